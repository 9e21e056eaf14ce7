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
    public void The_packed_sources_compile_alone_and_with_the_packages_of_a_project(bool isEditor, bool hasOtherPackages)
    {
        var compiler = new UnityCompiler(Package, isEditor, hasOtherPackages);

        compiler.CompileAll();

        int samples = Package.AssetFolders.Count(static folder => AssetPath.ParentOf(folder) == AssetPath.Samples);
        Assert.Equal(samples + (isEditor ? 3 : 2) + (hasOtherPackages ? isEditor ? 4 : 3 : 0), compiler.Definitions.Length);
        Assert.Equal(compiler.Definitions.Length, compiler.Compiled.Count);
        Assert.Equal(hasOtherPackages, compiler.Compiled.Contains("NeuronMocap.Unity.Timeline"));
        Assert.Equal(hasOtherPackages, compiler.Compiled.Contains("NeuronMocap.Unity.LiveCapture"));
        Assert.Equal(hasOtherPackages && isEditor, compiler.Compiled.Contains("NeuronMocap.Unity.Timeline.Editor"));
        Assert.Equal(hasOtherPackages, compiler.Compiled.Contains("NeuronMocap.Unity.InputSystem"));
    }
}
