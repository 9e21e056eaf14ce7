namespace NeuronMocap.AspNetCore;

/// <summary>What the messages of a WebSocket client contain. The client chooses it by the subprotocol of that name in lower case.</summary>
public enum WebSocketForm
{
    /// <summary>One line of JSON for each frame, with the fields of <c>neuron-mocap watch --json</c>. Clients that name no subprotocol get it.</summary>
    Json,

    /// <summary>One packet for each frame, bit for bit as it arrived.</summary>
    Packet,

    /// <summary>One <see cref="CompactPose"/> for each motion frame of 59 bones. Other frames are left out.</summary>
    Pose,
}
