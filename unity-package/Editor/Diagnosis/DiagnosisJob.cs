#nullable enable

using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using NeuronMocap.Diagnostics;

namespace NeuronMocap.Unity.EditorTools
{
    // A diagnosis that runs on the thread pool. The editor polls it; members are for the main thread, which never waits.
    internal sealed class DiagnosisJob : IProgress<DiagnosisStep>, IDisposable
    {
        private readonly CancellationTokenSource _stopSource = new CancellationTokenSource();
        private readonly List<DiagnosisStep> _steps = new List<DiagnosisStep>();
        private readonly Task<StreamDiagnosis> _task;

        // after: a task that must end first, such as the closing of another reader's socket.
        public DiagnosisJob(NeuronReaderOptions options, Task after, DiagnosisOptions? how = null)
        {
            Target = Describe(options);
            _task = Task.Run(() => RunAsync(options, after, how));
        }

        public string Target { get; }

        public bool IsRunning => !_task.IsCompleted;

        public StreamDiagnosis? Result => _task.Status == TaskStatus.RanToCompletion ? _task.Result : null;

        public string? Failure => _task.Exception?.InnerException?.Message;

        public bool IsCancelled => _task.IsCanceled;

        // For callers that wait without blocking. It never throws.
        public Task Completion => _task.ContinueWith(static _ => { }, TaskScheduler.Default);

        // Returns a copy, because the job adds to its list on a pool thread.
        public DiagnosisStep[] GetSteps()
        {
            lock (_steps)
                return _steps.ToArray();
        }

        public void Cancel()
        {
            if (IsRunning)
                _stopSource.Cancel();
        }

        // Does not dispose the source of the token, because the task may still use it for a moment.
        public void Dispose() => Cancel();

        void IProgress<DiagnosisStep>.Report(DiagnosisStep value)
        {
            lock (_steps)
                _steps.Add(value);
        }

        private async Task<StreamDiagnosis> RunAsync(NeuronReaderOptions options, Task after, DiagnosisOptions? how)
        {
            // Whether it succeeded or failed.
            await Task.WhenAny(after).ConfigureAwait(false);
            return await NeuronDiagnostics.DiagnoseAsync(options, how, this, _stopSource.Token).ConfigureAwait(false);
        }

        private static string Describe(NeuronReaderOptions options) => options.Transport == TransportKind.Udp
            ? $"UDP port {options.Port} of this computer"
            : $"{options.Host}:{options.Port} over TCP";
    }
}
