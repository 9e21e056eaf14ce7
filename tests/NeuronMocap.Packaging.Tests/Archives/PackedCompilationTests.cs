using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Archives;

// Compiles the tarball as Unity does.
public sealed class PackedCompilationTests
{
    private static readonly StagedPackage Package = UpmTarball.Read(UpmTarball.Create(ThePackage.Staged));

    [Theory]
    [InlineData(true, false)]
    [InlineData(false, false)]
    [InlineData(true, true)]
    [InlineData(false, true)]
    public void The_packed_sources_compile_alone_and_with_the_package_of_Timeline(bool isEditor, bool hasTimeline)
    {
        var compiler = new UnityCompiler(Package, isEditor, hasTimeline);

        compiler.CompileAll();

        int samples = Package.AssetFolders.Count(static folder => AssetPath.ParentOf(folder) == AssetPath.Samples);
        Assert.Equal(samples + (isEditor ? 3 : 2) + (hasTimeline ? 1 : 0), compiler.Definitions.Length);
        Assert.Equal(compiler.Definitions.Length, compiler.Compiled.Count);
        Assert.Equal(hasTimeline, compiler.Compiled.Contains("NeuronMocap.Unity.Timeline"));
    }
}
