using System;
using System.Diagnostics;
using System.Threading;

// A stand-alone program: receives from a port until the server closes the connection, and reports what it received.
public static class ScriptProgram
{
    public static int Main(string[] args)
    {
        int port = int.Parse(args[0]);
        int frames = int.Parse(args[1]);
        Stopwatch watch = Stopwatch.StartNew();
        Console.WriteLine(NeuronDataReaderWraper.NeuronDataReader.strBRGetLastErrorMessage());
        W2Script.Init(new IntPtr(5), new IntPtr(6));
        IntPtr connection = W2Script.Connect("127.0.0.1", port);
        while (W2Script.Count(W2Script.CalculationFrames) < frames || W2Script.IsRunning(connection))
        {
            if (watch.Elapsed > TimeSpan.FromSeconds(30))
                break;
            Thread.Sleep(1);
        }

        Console.WriteLine("motion " + W2Script.Count(W2Script.Frames) + " " + Sum(W2Script.Frames.ToArray()));
        Console.WriteLine("calculation " + W2Script.Count(W2Script.CalculationFrames) + " " + Sum(W2Script.CalculationFrames.ToArray()));

        // A closed port and an invalid name: connecting fails, and the program continues.
        UserScripts.ManagedScript refused = UserScripts.ManagedScript.Connect("127.0.0.1", 1, 0, false);
        IntPtr unknown = W2Script.Connect("no-such-computer.invalid", port);
        Console.WriteLine((refused == null) + " " + unknown + " " + W2Script.IsRunning(connection));
        W2Script.CloseAll();
        foreach (string line in W2Script.Log)
            Console.WriteLine(line.TrimEnd('\n'));
        return 0;
    }

    // Computes a sum over all bits of all values, in order.
    public static uint Sum(ReceivedFrame[] frames)
    {
        uint sum = 17;
        foreach (ReceivedFrame frame in frames)
        {
            foreach (float value in frame.Values)
                sum = unchecked((sum * 31) + (uint)BitConverter.ToInt32(BitConverter.GetBytes(value), 0));
        }

        return sum;
    }
}
