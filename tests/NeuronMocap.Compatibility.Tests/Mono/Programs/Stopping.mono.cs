using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Reflection;
using System.Threading;
using NeuronMocap;
using NeuronMocap.Commands;
using NeuronMocap.Recording;
using NeuronMocap.Server;

// Compiled and run by Mono. Repeatedly stops everything that can be stopped, in every state, and prints the times in milliseconds.
public static class Program
{
    private const int Rounds = 15;

    // For a reader that waits in vain. Everything that ends on its own takes less, even on a busy computer.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromMinutes(1);

    private static int silentPort;
    private static int sendingPort;
    private static int blackHolePort;
    private static int closedPort;

    // Arguments: the ports of a server that sends nothing, one that always sends, and one that does not answer; then a path for a recording.
    public static void Main(string[] arguments)
    {
        silentPort = int.Parse(arguments[0]);
        sendingPort = int.Parse(arguments[1]);
        blackHolePort = int.Parse(arguments[2]);
        var closed = new TcpListener(IPAddress.Loopback, 0);
        closed.Start();
        closedPort = ((IPEndPoint)closed.LocalEndpoint).Port;
        closed.Stop();
        Record(arguments[3]);

        // A first run, for objects that the runtime creates once and keeps.
        Measure(() => Tcp(sendingPort), UntilFrames);
        Measure(Udp, SendDatagrams);
        GC.Collect();
        int threads = CountThreads();
        int files = CountFiles();

        Show("created", () => Tcp(silentPort), null);
        Show("started", () => Tcp(silentPort), reader => { });
        Show("resolving", () => new NeuronReader(Patient(new NeuronReaderOptions { Host = "no-such-computer.invalid", Port = 7001 })), UntilSome);
        Show("connecting", () => Tcp(blackHolePort), UntilSome);
        Show("waiting", () => Tcp(closedPort), reader => Until(() => reader.Status.State == ConnectionState.Waiting));
        Show("silent", () => Tcp(silentPort), reader => Until(() => reader.Status.State == ConnectionState.Connected));
        Show("receiving", () => Tcp(sendingPort), UntilFrames);
        Show("delivering", () => Handling(Tcp(sendingPort), _ => Thread.Sleep(20)), UntilFrames);
        Show("from a handler", () => Handling(Tcp(sendingPort), reader => reader.Dispose()), reader => Until(() => reader.Completion.IsCompleted));
        Show("UDP silent", Udp, reader => Until(() => reader.Status.State == ConnectionState.Connected));
        Show("UDP receiving", Udp, SendDatagrams);
        Show("playing", () => Playing(arguments[3], isPaused: false), UntilFrames);
        Show("paused", () => Playing(arguments[3], isPaused: true), UntilFrames);
        ShowBroadcaster("broadcaster", hasClient: false);
        ShowBroadcaster("broadcaster with a client", hasClient: true);

        ShowCommandClient("command client connecting", blackHolePort);
        ShowCommandClient("command client asking", silentPort);
        ShowStarved("waiting", () => Tcp(closedPort), reader => Until(() => reader.Status.State == ConnectionState.Waiting));
        ShowStarved("receiving", () => Tcp(sendingPort), UntilFrames);
        ShowStarved("UDP receiving", Udp, SendDatagrams);

        for (int i = 0; i < 50; i++)
            Measure(() => Tcp(sendingPort), UntilFrames);

        DateTime end = DateTime.UtcNow.AddSeconds(20);
        while ((CountThreads() > threads || CountFiles() > files) && DateTime.UtcNow < end)
        {
            GC.Collect();
            Thread.Sleep(20);
        }

        Console.WriteLine("left: " + Math.Max(0, CountThreads() - threads) + " threads, " + Math.Max(0, CountFiles() - files) + " files");
    }

    private static void Show(string state, Func<NeuronReader> create, Action<NeuronReader> reach)
    {
        var times = new List<double>();
        for (int i = 0; i < Rounds; i++)
            times.Add(Measure(create, reach));

        Print(state, times);
    }

    // All threads of the pool are busy, and the pool adds no more.
    private static void ShowStarved(string state, Func<NeuronReader> create, Action<NeuronReader> reach)
    {
        int workers, completers;
        ThreadPool.GetMaxThreads(out workers, out completers);
        var times = new List<double>();
        for (int i = 0; i < 3; i++)
        {
            NeuronReader reader = create();
            reader.Start();
            reach(reader);
            var free = new ManualResetEvent(false);
            ThreadPool.SetMaxThreads(Environment.ProcessorCount, completers);
            var ran = new AutoResetEvent(false);
            do
            {
                ThreadPool.QueueUserWorkItem(delegate { free.WaitOne(); });
                ThreadPool.QueueUserWorkItem(delegate { ran.Set(); });
            }
            while (ran.WaitOne(200));

            times.Add(Measure(() => reader, null));
            ThreadPool.SetMaxThreads(workers, completers);
            free.Set();
            ran.WaitOne();
        }

        Print(state + " in a starved process", times);
    }

    // Prints the shortest time in milliseconds. A busy computer may delay some runs, but a stop that waits in vain is slow every time.
    private static void Print(string state, List<double> times)
    {
        Console.WriteLine(state + ": " + times.Min().ToString("0.0", System.Globalization.CultureInfo.InvariantCulture));
    }

    private static double Measure(Func<NeuronReader> create, Action<NeuronReader> reach)
    {
        NeuronReader reader = create();
        if (reach != null)
        {
            reader.Start();
            reach(reader);
        }

        var watch = Stopwatch.StartNew();
        reader.Dispose();
        double time = watch.Elapsed.TotalMilliseconds;
        if (!reader.Completion.IsCompleted || reader.Status.State != ConnectionState.Stopped || time > StopTimeout.TotalMilliseconds / 2)
            throw new InvalidOperationException("It has not stopped, or late: " + reader.Status.Message);

        return time;
    }

    private static void ShowBroadcaster(string state, bool hasClient)
    {
        var times = new List<double>();
        for (int i = 0; i < Rounds; i++)
        {
            var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = new MotionSource[] { new SyntheticSource() }, Port = 0 });
            broadcaster.Start();
            using (NeuronReader reader = Tcp(broadcaster.LocalEndPoint.Port))
            {
                if (hasClient)
                {
                    reader.Start();
                    UntilFrames(reader);
                }

                var watch = Stopwatch.StartNew();
                broadcaster.Dispose();
                times.Add(watch.Elapsed.TotalMilliseconds);
            }
        }

        Print(state, times);
    }

    private static void ShowCommandClient(string state, int port)
    {
        var times = new List<double>();
        for (int i = 0; i < Rounds; i++)
        {
            var client = new NeuronCommandClient(new NeuronCommandOptions { Port = port });
            System.Threading.Tasks.Task asking = client.GetRotationOrderAsync();
            Thread.Sleep(10);
            var watch = Stopwatch.StartNew();
            client.Dispose();
            times.Add(watch.Elapsed.TotalMilliseconds);
            Until(() => asking.IsFaulted && asking.Exception != null);
        }

        Print(state, times);
    }

    private static NeuronReader Tcp(int port)
    {
        var options = new NeuronReaderOptions { Port = port };
        options.Reconnect.InitialDelay = TimeSpan.FromHours(1);
        options.Reconnect.MaxDelay = TimeSpan.FromHours(1);
        return new NeuronReader(Patient(options));
    }

    private static NeuronReader Udp()
    {
        return new NeuronReader(Patient(new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 }));
    }

    private static NeuronReaderOptions Patient(NeuronReaderOptions options)
    {
        typeof(NeuronReaderOptions).GetProperty("StopTimeout", BindingFlags.Instance | BindingFlags.NonPublic).SetValue(options, StopTimeout, null);
        return options;
    }

    private static NeuronReader Handling(NeuronReader reader, Action<NeuronReader> handle)
    {
        reader.MotionReceived += delegate { handle(reader); };
        return reader;
    }

    // The frames are an hour apart.
    private static NeuronReader Playing(string path, bool isPaused)
    {
        RecordingPlayer player = RecordingPlayer.Open(path);
        var reader = new NeuronReader(player, Patient(new NeuronReaderOptions()));
        reader.MotionReceived += delegate
        {
            if (isPaused)
                player.Pause();
        };
        reader.StatusChanged += status =>
        {
            if (status.State == ConnectionState.Stopped)
                player.Dispose();
        };
        return reader;
    }

    // Records a frame of a broadcast, and the same frame an hour later.
    private static void Record(string path)
    {
        byte[] frame = new byte[1480];
        using (var client = new TcpClient("127.0.0.1", sendingPort))
        {
            for (int length = 0; length < frame.Length;)
                length += client.GetStream().Read(frame, length, frame.Length - length);
        }

        using (var writer = NeuronMocap.Recording.RecordingWriter.Create(path))
        {
            writer.OpenConnection(TimeSpan.Zero, new NeuronMocap.Recording.RecordedConnection(0, TransportKind.Tcp, "", ""));
            writer.WriteBytes(TimeSpan.Zero, 0, frame);
            writer.WriteBytes(TimeSpan.FromHours(1), 0, frame);
        }
    }

    private static void SendDatagrams(NeuronReader reader)
    {
        byte[] frame = new byte[1480];
        using (var client = new TcpClient("127.0.0.1", sendingPort))
        {
            for (int length = 0; length < frame.Length;)
                length += client.GetStream().Read(frame, length, frame.Length - length);
        }

        using (var sender = new UdpClient())
        {
            Until(() =>
            {
                var port = reader.Status.LocalEndPoint as IPEndPoint;
                if (port != null)
                    sender.Send(frame, frame.Length, port);

                return reader.GetStatistics().MotionFrames > 2;
            });
        }
    }

    private static void UntilFrames(NeuronReader reader)
    {
        Until(() => reader.GetStatistics().MotionFrames > 0);
    }

    private static void UntilSome(NeuronReader reader)
    {
        Until(() => reader.Status.State == ConnectionState.Connecting);
        Thread.Sleep(10);
    }

    private static void Until(Func<bool> condition)
    {
        DateTime end = DateTime.UtcNow.AddSeconds(30);
        while (!condition())
        {
            if (DateTime.UtcNow > end)
                throw new TimeoutException();

            Thread.Sleep(1);
        }
    }

    private static int CountThreads()
    {
        return Directory.GetDirectories("/proc/self/task").Count(IsOurs);
    }

    private static bool IsOurs(string task)
    {
        try
        {
            return File.ReadAllText(Path.Combine(task, "comm")).StartsWith("NeuronMocap", StringComparison.Ordinal);
        }
        catch (IOException)
        {
            return false; // it ended in the meantime
        }
    }

    private static int CountFiles()
    {
        return Directory.GetFileSystemEntries("/proc/self/fd").Length;
    }
}
