using System.Reflection;
using System.Runtime.InteropServices;
using NeuronMocap.Tests.Architecture;

namespace NeuronMocap.Compatibility.Tests.Surface;

public sealed class SurfaceTests
{
    private static readonly string[] Namespaces = ["NeuronDataReaderWraper", "NeuronDataReaderManaged"];
    private static readonly Assembly Library = typeof(CompatibilityEvents).Assembly;

    [Fact]
    public void The_public_API_matches_its_file() => PublicSurfaceFile.Check(Library);

    [Fact]
    public void The_tests_run_against_the_build_that_was_asked_for() => Assert.All(
        (Assembly[])[Library, typeof(NeuronReader).Assembly, typeof(Server.Broadcaster).Assembly],
        static assembly => Assert.True(LibraryBuild.Holds(assembly)));

    [Fact]
    public void Both_namespaces_have_the_same_surface()
    {
        ILookup<string, string> lines = PublicSurface.Of(Library).ToLookup(static line => line.Split('.')[0], StringComparer.Ordinal);
        Assert.True(lines[Namespaces[0]].Count() > 100);
        Assert.Equal(
            lines[Namespaces[0]].Select(static line => line.Replace(Namespaces[0], Namespaces[1], StringComparison.Ordinal)),
            lines[Namespaces[1]]);
    }

    // A script may have "using NeuronDataReaderWraper;" and call "NeuronDataReader.BRConnectTo(...)". A namespace named NeuronDataReader would hide
    // the class. Neuron and Noitom are namespaces of the vendor's own scripts.
    [Fact]
    public void No_namespace_hides_the_class()
    {
        string[] tops = [.. Library.GetExportedTypes().Select(static type => type.Namespace!).Distinct(StringComparer.Ordinal).Order(StringComparer.Ordinal)];
        Assert.Equal(["NeuronDataReaderManaged", "NeuronDataReaderWraper", "NeuronMocap.Compatibility"], tops);
    }

    [Theory]
    [InlineData("BvhDataHeader", 64, "Token1 0, DataVersion 2, DataCount 6, bWithDisp 8, bWithReference 9, AvatarIndex 10, AvatarName 14, "
        + "FrameIndex 46, Reserved 50, Reserved1 54, Reserved2 58, Token2 62")]
    [InlineData("CalcDataHeader", 64, "Token1 0, DataVersion 2, DataCount 6, AvatarIndex 10, AvatarName 14, FrameIndex 46, Reserved1 50, "
        + "Reserved2 54, Reserved3 58, Token2 62")]
    [InlineData("CommandPack", 64, "Token1 0, DataVersion 2, DataLength 6, DataCount 10, CommandId 14, CmdParaments 18, Reserved1 58, Token2 62")]
    [InlineData("CmdResponseBoneSize", 64, "BoneName 0, BoneLength 60")]
    [InlineData("DataVersion", 4, "BuildNumb 0, Revision 1, Minor 2, Major 3")]
    [InlineData("BoneDimension", 48, "Head 0, Neck 4, Body 8, ShoulderWidth 12, UpperArm 16, Forearm 20, Palm 24, HipWidth 28, UpperLeg 32, "
        + "LowerLeg 36, HeelHeight 40, FootLength 44")]
    public void Structs_have_the_vendors_memory_layout(string name, int size, string offsets)
    {
        foreach (string space in Namespaces)
        {
            Type type = Library.GetType($"{space}.{name}", throwOnError: true)!;
            Assert.Equal(size, Marshal.SizeOf(type));
            Assert.Equal(offsets, string.Join(", ", type.GetFields().Select(field => $"{field.Name} {Marshal.OffsetOf(type, field.Name)}")));
        }
    }

    [Theory]
    [InlineData("FrameDataReceived")]
    [InlineData("SocketStatusChanged")]
    [InlineData("CommandDataReceived")]
    public void Delegates_of_the_native_wrapper_have_its_calling_convention(string name)
    {
        Type native = Library.GetType($"{Namespaces[0]}.{name}", throwOnError: true)!;
        Type managed = Library.GetType($"{Namespaces[1]}.{name}", throwOnError: true)!;
        Assert.Equal(CallingConvention.StdCall, native.GetCustomAttribute<UnmanagedFunctionPointerAttribute>()?.CallingConvention);
        Assert.Null(managed.GetCustomAttribute<UnmanagedFunctionPointerAttribute>());
    }
}
