using System.Globalization;
using System.Runtime.InteropServices;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Allocations;

// A long stream at full speed, through the library itself.
public sealed class StreamTests
{
    private const int Frames = 200_000;
    private const int FramesInBlock = 200;

    // The receive buffer may still double once or twice, 480 KiB in total. Ten bytes for each frame would be four times as much.
    private const long MostPages = 512 * 1024 / 4096;

    [Fact]
    public async Task Every_bit_of_200_000_frames_arrives_in_constant_memory()
    {
        byte[] block = TestPackets.Motions(first: 1, FramesInBlock);
        ulong sum = 0;
        foreach (uint word in MemoryMarshal.Cast<byte, uint>(block))
            sum += word;

        using var server = new TestServer();
        await using NativeProgram program = NativeProgram.Start("bench-library", "check", server.Port.ToString(CultureInfo.InvariantCulture), Frames.ToString(CultureInfo.InvariantCulture));
        using TestConnection connection = await server.AcceptAsync();
        for (int sent = 0; sent < Frames; sent += FramesInBlock)
            await connection.SendAsync(block);
        connection.Close();

        Assert.Equal(0, await ReadAsync("allocations "));
        Assert.InRange(await ReadAsync("faults "), 0, MostPages);
        Assert.InRange(await ReadAsync("resident "), 0, MostPages);
        Assert.Equal(Frames, await ReadAsync("frames "));
        Assert.Equal((long)sum * (Frames / FramesInBlock), await ReadAsync("sum "));
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);

        async Task<long> ReadAsync(string name) => long.Parse((await program.ReadAsync(name))[name.Length..], CultureInfo.InvariantCulture);
    }
}
