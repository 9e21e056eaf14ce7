namespace NeuronMocap.Server.Broadcasting;

/// <summary>Gets the units of a reader's stream. The calls come one at a time, on the reader's threads. They must not wait or throw.</summary>
internal interface IUnitListener
{
    // The reader has a new connection, on which it can send.
    void OnConnected();

    // The units are valid during the call. incomplete is the number of packets that were cut off since the last call.
    void OnUnits(UnitBatch units, int incomplete);

    // Units are missing, because the system is out of memory.
    void OnFailed(Exception exception);
}
