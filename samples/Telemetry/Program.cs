using System.CommandLine;
using Microsoft.Extensions.Options;
using NeuronMocap.TelemetryExport;

const int Done = 0;
const int Failed = 1;
const int BadUsage = 2;

var command = new TelemetryCommand();
command.SetAction((parsed, _) => RunAsync(parsed));
ParseResult result = command.Parse(args);
if (result.Errors.Count > 0)
    return Fail(BadUsage, string.Join(Environment.NewLine, [.. result.Errors.Select(error => error.Message), TelemetryCommand.Usage]));

// Signals are the host's.
return await result.InvokeAsync(new InvocationConfiguration { ProcessTerminationTimeout = null, EnableDefaultExceptionHandler = false });

async Task<int> RunAsync(ParseResult parsed)
{
    var options = new TelemetryOptions(
        parsed.GetValue(command.Host),
        parsed.GetValue(command.Port),
        parsed.GetValue(command.Demo),
        parsed.GetValue(command.Otlp) ?? new Uri("http://127.0.0.1:4318/"),
        parsed.GetValue(command.Interval) ?? TimeSpan.FromSeconds(10),
        parsed.GetValue(command.Duration));
    try
    {
        return await new TelemetryRun(options).RunAsync() is { } failure ? Fail(Failed, failure) : Done;
    }
    catch (OptionsValidationException exception)
    {
        return Fail(BadUsage, string.Join(Environment.NewLine, exception.Failures));
    }
}

static int Fail(int code, string message)
{
    Console.Error.WriteLine($"neuron-telemetry: {message}");
    return code;
}
