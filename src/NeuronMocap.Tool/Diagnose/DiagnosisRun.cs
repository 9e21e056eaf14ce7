using NeuronMocap.Diagnostics;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>Diagnoses the stream once.</summary>
internal sealed class DiagnosisRun(ConnectionOptions options, OutputKind kind, StandardStreams streams)
{
    public async Task<int> RunAsync(CancellationToken cancellationToken)
    {
        try
        {
            using Broadcaster? demo = options.IsDemo ? Broadcaster.StartDemo(rotationOrder: options.RotationOrder ?? RotationOrder.YXZ) : null;
            return await RunAsync(demo is null ? options.Server : ServerAddress.Of(demo.LocalEndPoint!), cancellationToken);
        }
        catch (BroadcasterException exception)
        {
            return await FailAsync(OptionNames.Translate(exception.Message));
        }
        catch (OperationCanceledException)
        {
            return ToolCommand.Interrupted;
        }
        catch (IOException exception)
        {
            // The program that reads the output may close it at any time.
            return StandardStreams.IsBrokenPipe(exception)
                ? ToolCommand.Interrupted
                : await FailAsync(FileFault.OfStandardOutput(exception));
        }
    }

    private async Task<int> RunAsync(ServerAddress? server, CancellationToken cancellationToken)
    {
        NeuronReaderOptions reader = options.ToReaderOptions(server);
        var how = new DiagnosisOptions();
        if (options.Duration is { } duration)
            how.Timeout = duration;

        DiagnosisOutput output = CreateOutput(reader);
        StreamDiagnosis diagnosis = await NeuronDiagnostics.DiagnoseAsync(reader, how, output, cancellationToken);
        output.Finish(diagnosis);
        return diagnosis.IsReceiving ? ToolCommand.Done : ToolCommand.NothingReceived;
    }

    private DiagnosisOutput CreateOutput(NeuronReaderOptions reader)
    {
        if (kind != OutputKind.Person)
            return new JsonDiagnosis(streams.Output, quiet: kind == OutputKind.Quiet);

        var output = new TextDiagnosis(streams);
        output.Begin(reader.Transport == TransportKind.Udp
            ? $"UDP port {reader.Port} of this computer"
            : options.WebSocket is not null ? options.Source
            : $"{new ServerAddress(reader.Host, reader.Port)} over {(reader.Tls is null ? "TCP" : "TLS")}");
        return output;
    }

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return ToolCommand.NothingReceived;
    }
}
