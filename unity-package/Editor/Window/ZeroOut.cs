#nullable enable

using System;
using System.Runtime.CompilerServices;
using System.Threading;
using System.Threading.Tasks;
using NeuronMocap.Commands;

namespace NeuronMocap.Unity.EditorTools
{
    // Asks the server to zero out avatars, on the thread pool.
    internal sealed class ZeroOut : IDisposable
    {
        private readonly CancellationTokenSource _stopSource = new CancellationTokenSource();
        private readonly Task _task;
        private readonly string _whom;

        // avatar: null for all avatars.
        public ZeroOut(string host, int commandPort, int? avatar)
        {
            _whom = avatar is { } index ? $"avatar {index}" : "all avatars";
            _task = Task.Run(() => RunAsync(host, commandPort, avatar, _stopSource.Token));
        }

        public bool IsRunning => !_task.IsCompleted;

        public Severity Severity => IsRunning ? Severity.Waiting : _task.Status == TaskStatus.RanToCompletion ? Severity.Good : Severity.Error;

        public string Describe()
        {
            if (IsRunning)
                return $"Zeroing {_whom} out";

            return _task.Exception?.InnerException is { } fault ? fault.Message : _task.IsCanceled ? "Cancelled" : $"Zeroed {_whom} out";
        }

        // Cancels without waiting for the task to end.
        public void Dispose() => _stopSource.Cancel();

        private static async Task RunAsync(string host, int port, int? avatar, CancellationToken cancellationToken)
        {
            var client = new NeuronCommandClient(host, port);
            await using ConfiguredAsyncDisposable closing = client.ConfigureAwait(false);
            await (avatar is { } index ? client.ZeroOutAsync(index, cancellationToken) : client.ZeroOutAllAsync(cancellationToken)).ConfigureAwait(false);
        }
    }
}
