namespace NeuronMocap.Server.Sources;

// A frame of a recorded take. Its values are as received, or interpolated between neighbours.
internal sealed class RecordedTakeRow(float[] values, uint? index, TimeSpan time, int connection)
{
    public float[] Values => values;

    public uint? Index => index;

    public TimeSpan Time => time;

    public int Connection => connection;

    public FootContacts? Contacts { get; set; }
}
