namespace NeuronMocap.Telemetry;

// The names of the tags, and the tags that never change. All have few values, so none contains an avatar: avatar names and numbers come from the network.
internal static class MeterTags
{
    public const string Reader = "neuron.reader.name";
    public const string Kind = "neuron.frame.kind";
    public const string Consumer = "neuron.consumer.name";
    public const string Reason = "neuron.skip.reason";
    public const string State = "neuron.connection.state";
    public const string Buffer = "neuron.buffer.size";

    public static readonly KeyValuePair<string, object?> Granted = new(Buffer, "granted");
    public static readonly KeyValuePair<string, object?> Requested = new(Buffer, "requested");
    public static readonly KeyValuePair<string, object?> Motion = new(Kind, "motion");
    public static readonly KeyValuePair<string, object?> Calculation = new(Kind, "calculation");
    public static readonly KeyValuePair<string, object?> StudioCalculation = new(Kind, "studio_calculation");
}
