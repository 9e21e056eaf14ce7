using System.Runtime.InteropServices;
using System.Text;
using NeuronDataReaderWraper;
using NeuronMocap.Tests.Commands;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// The overloads that exist only in C#.
public sealed class HeaderMemoryTests
{
    private const string Bvh = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
        + " End Site\n {\n  OFFSET 0 1 0\n }\n}\n";

    [Fact]
    public void The_header_fits_into_a_text_or_unmanaged_memory()
    {
        using CommandScript server = Answers();
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);

        var text = new StringBuilder("before");
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, text, 100_000));
        Assert.Equal(Bvh, text.ToString());
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, text, 9));
        Assert.Equal("HIERARCHY", text.ToString());

        IntPtr memory = Marshal.AllocHGlobal(1000);
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, memory, 1000));
        Assert.Equal(Bvh, Marshal.PtrToStringAnsi(memory));
        Marshal.FreeHGlobal(memory);

        Assert.False(NeuronDataReader.GetBvhHeader(pipe, 0, IntPtr.Zero, 1000));
        Assert.False(NeuronDataReader.GetBvhHeader(pipe, 0, text, -1));
        NeuronDataReader.BRCloseSocket(pipe);
    }

    [Fact]
    public void A_text_of_limited_capacity_is_filled()
    {
        using CommandScript server = Answers();
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        var text = new StringBuilder(4, 9);

        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, text, 100_000));

        Assert.Equal("HIERARCHY", text.ToString());
        NeuronDataReader.BRCloseSocket(pipe);
    }

    [Fact]
    public void An_invalid_header_leaves_the_text_alone()
    {
        using CommandScript server = CommandScript.Always("no BVH"u8.ToArray());
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        var text = new StringBuilder("before");

        Assert.False(NeuronDataReader.GetBvhHeader(pipe, 0, text, 100));

        Assert.Equal("before", text.ToString());
        NeuronDataReader.BRCloseSocket(pipe);
    }

    private static CommandScript Answers() => CommandScript.Always(Encoding.ASCII.GetBytes(Bvh));
}
