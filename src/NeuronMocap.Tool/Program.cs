using System.Runtime.InteropServices;
using NeuronMocap.Tool;
using NeuronMocap.Tool.Terminal;

using var cancellationSource = new CancellationTokenSource();
using PosixSignalRegistration interrupt = CancelOn(PosixSignal.SIGINT);
using PosixSignalRegistration terminate = CancelOn(PosixSignal.SIGTERM);
using PosixSignalRegistration hangUp = CancelOn(PosixSignal.SIGHUP);
using StandardStreams streams = StandardStreams.Open();

return await CommandLine.RunAsync(args, streams, cancellationSource.Token);

PosixSignalRegistration CancelOn(PosixSignal signal) => PosixSignalRegistration.Create(signal, context =>
{
    context.Cancel = true;
    cancellationSource.Cancel();
});
