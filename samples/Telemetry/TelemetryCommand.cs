using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using System.Globalization;

namespace NeuronMocap.TelemetryExport;

/// <summary>The options of the program and their help.</summary>
internal sealed class TelemetryCommand : RootCommand
{
    public const string Usage = "Usage: neuron-telemetry [--host HOST] [--port PORT] [--demo] [--otlp URL] [--interval SECONDS] [--duration SECONDS]";

    public TelemetryCommand()
        : base("Receives a Perception Neuron stream as a service of the .NET generic host, and sends the reader's metrics and logs to an "
            + "OpenTelemetry collector.")
    {
        Otlp.CustomParser = ParseUrl;
        Interval.CustomParser = ParseSeconds;
        Duration.CustomParser = ParseSeconds;
        foreach (Option option in (Option[])[Host, Port, Demo, Otlp, Interval, Duration])
            Add(option);

        Validators.Add(result =>
        {
            if (result.GetResult(Demo) is { Implicit: false } && (result.GetResult(Host) ?? result.GetResult(Port)) is { Implicit: false })
                result.AddError("--demo is a server of its own: leave out --host and --port.");
        });
        Options.OfType<HelpOption>().Single().Action = new HelpWithExamples();
    }

    public Option<string?> Host { get; } = new("--host")
    {
        HelpName = "HOST",
        Description = "Computer that runs Axis Neuron. Default: the setting NeuronReader:Host, or the demo if there is none.",
    };

    public Option<string?> Port { get; } = new("--port") { HelpName = "PORT", Description = "The server's port. Default: the setting NeuronReader:Port, or 7001." };

    public Option<bool> Demo { get; } = new("--demo") { Description = "Receive from a simulator inside this program, whatever the settings say." };

    public Option<Uri?> Otlp { get; } = new("--otlp")
    {
        HelpName = "URL",
        Description = "The collector, which takes OTLP over HTTP. Default: http://127.0.0.1:4318.",
    };

    public Option<TimeSpan?> Interval { get; } = new("--interval")
    {
        HelpName = "SECONDS",
        Description = "Time between two exports of the metrics, as in 0.5; 0.1 to 86400. Default: 10.",
    };

    public Option<TimeSpan?> Duration { get; } = new("--duration")
    {
        HelpName = "SECONDS",
        Description = "End after this many seconds, 0.1 to 86400. Default: when told to, by Ctrl+C or SIGTERM.",
    };

    private static Uri? ParseUrl(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (Uri.TryCreate(text.EndsWith('/') ? text : text + "/", UriKind.Absolute, out Uri? url) && url.Scheme is "http" or "https")
            return url;

        result.AddError($"--otlp {text} is not the address of a collector, such as http://127.0.0.1:4318.");
        return null;
    }

    private static TimeSpan? ParseSeconds(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double seconds) && seconds is >= 0.1 and <= 86_400)
            return TimeSpan.FromSeconds(seconds);

        result.AddError($"{(result.Parent as OptionResult)?.Option.Name} {text} is not a number of seconds from 0.1 to 86400.");
        return null;
    }

    private sealed class HelpWithExamples : SynchronousCommandLineAction
    {
        private readonly HelpAction _help = new();

        public override int Invoke(ParseResult parseResult)
        {
            int code = _help.Invoke(parseResult);
            parseResult.InvocationConfiguration.Output.WriteLine("""
                The reader's options are those of the section NeuronReader in appsettings.json, or of environment variables such as
                NeuronReader__SilenceTimeout=00:00:10.

                Examples:
                  neuron-telemetry
                      The demo, to a collector on this computer.
                  neuron-telemetry --host 192.168.1.20 --otlp http://collector:4318 --interval 5
                      A suit, to a collector elsewhere.

                Exit codes: 0 ended as asked, 1 no frame arrived or the collector took nothing, 2 wrong options or settings.
                """);
            return code;
        }
    }
}
