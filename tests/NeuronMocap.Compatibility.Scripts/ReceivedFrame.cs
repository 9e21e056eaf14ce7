using System;

// The data that a script keeps of a frame.
public class ReceivedFrame
{
    public IntPtr Connection;
    public long CustomObject;
    public int Avatar;
    public string AvatarName;
    public uint FrameIndex;
    public bool WithDisplacement;
    public bool WithReference;
    public string Version;
    public float[] Values;
}
