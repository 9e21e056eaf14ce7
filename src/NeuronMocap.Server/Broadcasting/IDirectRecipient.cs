namespace NeuronMocap.Server.Broadcasting;

/// <summary>A recipient that takes units on the writer's thread while its own thread waits for the next one.</summary>
internal interface IDirectRecipient
{
    // Takes as many units as it can without waiting, and returns their number. Does not throw. Each unit has the given number of packets. Several units are
    // whole frames. A single unit may be the part of a frame that starts with the packet at index first.
    int Take(UnitBatch units, int packets, int first);

    // Whether it has sent everything that it took. Otherwise its thread must send the rest first.
    bool IsReady { get; }
}
