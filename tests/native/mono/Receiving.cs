// Receives through the native library with a user's script, while Mono collects garbage and catches null references. Arguments: two ports, a number of
// frames.
using System;
using System.Threading;
using NeuronDataReaderWraper;

public static class Receiving
{
    private static readonly string nothing = Environment.GetEnvironmentVariable("NO_SUCH_VARIABLE");

    public static int Main(string[] arguments)
    {
        int frames = int.Parse(arguments[2]);
        W2Script.Init(new IntPtr(5), new IntPtr(6));
        IntPtr refused = W2Script.Connect("127.0.0.1", 1);
        IntPtr connection = W2Script.Connect("127.0.0.1", int.Parse(arguments[0]));
        int caught = 0;
        while (W2Script.Count(W2Script.Frames) < frames || W2Script.Count(W2Script.CalculationFrames) < frames)
        {
            try
            {
                caught += nothing.Length;
            }
            catch (NullReferenceException)
            {
                caught = 1;
            }

            GC.Collect(0);
            Thread.Sleep(1);
        }

        Console.WriteLine("motion " + Check(W2Script.Frames.ToArray(), 5) + " calculation " + Check(W2Script.CalculationFrames.ToArray(), 6) + " caught " + caught);
        IntPtr commands = NeuronDataReader.BRConnectCmd("127.0.0.1", int.Parse(arguments[1]));
        Console.WriteLine((refused == IntPtr.Zero) + " " + NeuronDataReader.ZeroOut(commands, 0) + " " + NeuronDataReader.ZeroOut(commands, 99));
        W2Script.CloseAll();
        Console.WriteLine(W2Script.IsRunning(connection));
        foreach (string line in W2Script.Log)
            Console.WriteLine(line.TrimEnd('\n'));
        return 0;
    }

    // Describes the first frame if all frames follow one another; otherwise returns the index of the first gap.
    private static string Check(ReceivedFrame[] frames, long customObject)
    {
        uint index = 0;
        foreach (ReceivedFrame frame in frames)
        {
            if (frame.CustomObject == customObject && frame.FrameIndex == index && frame.AvatarName == "陈")
                index++;
        }

        return index == frames.Length ? frames[0].Version + " " + frames[0].Values.Length : "wrong after " + index;
    }
}
