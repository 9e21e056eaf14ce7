using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Mono;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Compatibility.Tests.Mono;

public sealed class MonoTests
{
    private const int Frames = 500;

    // What Unity's editor does when it reloads scripts that forget to close.
    private const string ReloadingProgram =
        """
        using System;
        using System.Net;
        using System.Net.Sockets;
        using NeuronDataReaderWraper;

        public class Script : MarshalByRefObject
        {
            public bool Open(int port)
            {
                NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, delegate { });
                return NeuronDataReader.BRConnectTo("127.0.0.1", port) != IntPtr.Zero
                    && NeuronDataReader.BRConnectCmd("127.0.0.1", port) != IntPtr.Zero;
            }
        }

        public static class Program
        {
            public static void Main()
            {
                var listener = new TcpListener(IPAddress.Loopback, 0);
                listener.Start();
                AppDomain domain = AppDomain.CreateDomain("scripts");
                var script = (Script)domain.CreateInstanceAndUnwrap(typeof(Script).Assembly.FullName, "Script");
                Console.WriteLine(script.Open(((IPEndPoint)listener.LocalEndpoint).Port));
                Socket[] clients = { listener.AcceptSocket(), listener.AcceptSocket() };
                AppDomain.Unload(domain);
                foreach (Socket client in clients)
                    Console.WriteLine(client.Poll(30000000, SelectMode.SelectRead) && client.Available == 0);
            }
        }
        """;

    [Fact]
    public async Task Scripts_receive_every_frame_on_Mono()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileAsync(Directory.GetFiles(Repository.PathOf("tests", "NeuronMocap.Compatibility.Scripts"), "*.cs"));
        foreach (DataVersion version in (DataVersion[])[DataVersion.New, DataVersion.Old])
        {
            var options = new BroadcasterOptions
            {
                Sources = [new TestSource(0, Frames), new TestSource(1, Frames)],
                Calculation = TestSource.WriteCalculation,
                DataVersion = version,
                Port = 0,
                FrameRate = BroadcasterOptions.MaxFrameRate,
                Fragment = 1000,
            };
            using var server = new Broadcaster(options);
            server.Start();
            int port = server.LocalEndPoint!.Port;

            string[] output = await program.RunAsync($"{port}", $"{2 * Frames}");

            Assert.Equal(
                [
                    "No error.",
                    $"motion {2 * Frames} {SumOf(options, 354, Write)}",
                    $"calculation {2 * Frames} {SumOf(options, 946, (source, frame, values) => options.Calculation(source, frame, values))}",
                    "True 0 False",
                    $"CS_Starting Connecting to 127.0.0.1:{port} ...",
                    $"CS_Running Successfully connected to '127.0.0.1:{port}'.",
                    "CS_Running Failed to read data.",
                    "CS_Running Data thread exited.",
                    $"CS_Starting Connecting to no-such-computer.invalid:{port} ...",
                    $"CS_Starting Failed to connect to 'no-such-computer.invalid:{port}'.",
                    "CS_OffWork Service is stoped",
                    $"Failed to connect to 'no-such-computer.invalid:{port}'. System error code: 11001",
                    "CS_OffWork Service is stoped",
                ],
                output);
        }
    }

    [Fact]
    public async Task Unclosed_connections_end_with_the_domain()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileAsync(ReloadingProgram);

        Assert.Equal(["True", "True", "True"], await program.RunAsync());
    }

    private static void Write(Server.MotionSource source, long frame, float[] values) =>
        source.WriteValues(frame, new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, values);

    private static uint SumOf(BroadcasterOptions options, int count, Action<Server.MotionSource, long, float[]> write)
    {
        var frames = new List<ReceivedFrame>();
        for (int frame = 0; frame < Frames; frame++)
        {
            foreach (Server.MotionSource source in options.Sources)
            {
                float[] values = new float[count];
                write(source, frame, values);
                frames.Add(new ReceivedFrame { Values = values });
            }
        }

        return ScriptProgram.Sum([.. frames]);
    }
}
