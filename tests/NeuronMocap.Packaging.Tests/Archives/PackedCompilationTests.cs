using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Archives;

// Compiles the tarball as Unity does.
public sealed class PackedCompilationTests
{
    private static readonly StagedPackage Package = UpmTarball.Read(UpmTarball.Create(ThePackage.Staged));

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_packed_sources_compile_alone(bool isEditor)
    {
        var compiler = new UnityCompiler(Package, isEditor);

        compiler.CompileAll();

        Assert.Equal(isEditor ? 8 : 7, compiler.Definitions.Length);
        Assert.Equal(compiler.Definitions.Length, compiler.Compiled.Count);
    }
}
