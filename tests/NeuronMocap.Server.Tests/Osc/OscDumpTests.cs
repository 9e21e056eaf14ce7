using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests.Osc;

// What oscdump understands, the receiver of liblo, a library in C that many programs use.
public sealed class OscDumpTests
{
    [Fact]
    public async Task Vmc_is_understood_by_liblo()
    {
        MotionFrame frame = Poses.Frame(4);
        var model = new VmcModel();
        await DumpAsync(
            frame,
            static (reader, port) => new VmcSender(reader, new VmcSenderOptions { Port = port, MaxRate = 0 }),
            "/VMC/Ext/T",
            message => model.Receive(message));

        // It prints six decimals.
        model.AssertShows(frame, tolerance: 3e-4f);
    }

    [Fact]
    public async Task Plain_osc_is_understood_by_liblo()
    {
        MotionFrame frame = Poses.Frame(5);
        Dictionary<string, OscMessage> bones = [];
        await DumpAsync(
            frame,
            static (reader, port) => new OscSender(reader, new OscSenderOptions { Port = port, MaxRate = 0 }),
            "/neuron/Ann/frame",
            message => bones[message.Address] = message);

        Assert.Equal(60, bones.Count);
        BoneTransform[] world = Poses.World(frame);
        for (int bone = 0; bone < world.Length; bone++)
            Poses.AssertSame(world[bone], Poses.TransformOf(bones[$"/neuron/Ann/{(Bone)bone}"]), 0.001f, $"{(Bone)bone}");

        Assert.Equal(5, bones["/neuron/Ann/frame"].Arguments[0]);
    }

    // Sends a frame again and again, because the program does not say when it receives, until it has shown a whole one.
    private static async Task DumpAsync(MotionFrame frame, Func<NeuronReader, int, PoseSender> create, string last, Action<OscMessage> receive)
    {
        int port = FreePort.Next();
        using Process program = Start(port);
        try
        {
            await DumpAsync(program, frame, reader => create(reader, port), last, receive);
        }
        finally
        {
            program.Kill();
        }

        await program.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
    }

    private static async Task DumpAsync(Process program, MotionFrame frame, Func<NeuronReader, PoseSender> create, string last, Action<OscMessage> receive)
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using PoseSender sender = create(reader);
        sender.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        using var end = new CancellationTokenSource();
        Task sending = SendAsync(source, frame, end.Token);
        int frames = 0;
        while (frames < 2 && await program.StandardOutput.ReadLineAsync(TestContext.Current.CancellationToken).AsTask().Soon() is { } line)
        {
            var message = OscMessage.ReadDump(line);

            // The first frame may be incomplete.
            if (frames == 1)
                receive(message);
            frames += string.Equals(message.Address, last, StringComparison.Ordinal) ? 1 : 0;
        }

        Assert.Equal(2, frames);
        await end.CancelAsync();
        await sending;
    }

    private static async Task SendAsync(TestConnection source, MotionFrame frame, CancellationToken cancellationToken)
    {
        byte[] packet = frame.Packet.ToArray();
        while (!cancellationToken.IsCancellationRequested)
        {
            await source.SendAsync(packet);
            await Task.Delay(20, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        }
    }

    private static Process Start(int port)
    {
        try
        {
            return Process.Start(new ProcessStartInfo("oscdump", ["-L", port.ToString(CultureInfo.InvariantCulture)]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            Assert.Skip("oscdump is not installed. It is in Debian's package liblo-tools.");
            throw;
        }
    }
}
