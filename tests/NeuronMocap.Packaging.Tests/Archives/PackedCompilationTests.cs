using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Archives;

// What Unity does with the tarball.
public sealed class PackedCompilationTests
{
    private static readonly StagedPackage Package = UpmTarball.Read(UpmTarball.Create(ThePackage.Staged));

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void All_that_is_packed_compiles_with_nothing_else(bool isEditor)
    {
        var compiler = new UnityCompiler(Package, isEditor);

        compiler.CompileAll();

        Assert.Equal(isEditor ? 8 : 7, compiler.Definitions.Length);
        Assert.Equal(compiler.Definitions.Length, compiler.Compiled.Count);
    }
}
