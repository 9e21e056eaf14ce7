using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Archives;

// Compiles the tarball as Unity does.
public sealed class PackedCompilationTests
{
    private static readonly StagedPackage Package = UpmTarball.Read(ThePackage.Tarball);

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_packed_sources_compile_alone_and_with_the_packages_of_a_project(bool isEditor)
    {
        var compiler = new UnityCompiler(Package, isEditor);
        CompileAll(compiler, isEditor ? 3 : 2, hasOtherPackages: false);
        Assert.DoesNotContain("NeuronMocap.Unity.Timeline.Editor", compiler.Compiled);

        compiler.InstallOtherPackages();
        CompileAll(compiler, isEditor ? 7 : 5, hasOtherPackages: true);
        Assert.Equal(isEditor, compiler.Compiled.Contains("NeuronMocap.Unity.Timeline.Editor"));
    }

    private static void CompileAll(UnityCompiler compiler, int assemblies, bool hasOtherPackages)
    {
        compiler.CompileAll();

        int samples = Package.AssetFolders.Count(static folder => AssetPath.ParentOf(folder) == AssetPath.Samples);
        Assert.Equal(samples + assemblies, compiler.Definitions.Length);
        Assert.Equal(compiler.Definitions.Length, compiler.Compiled.Count);
        Assert.Equal(hasOtherPackages, compiler.Compiled.Contains("NeuronMocap.Unity.Timeline"));
        Assert.Equal(hasOtherPackages, compiler.Compiled.Contains("NeuronMocap.Unity.LiveCapture"));
        Assert.Equal(hasOtherPackages, compiler.Compiled.Contains("NeuronMocap.Unity.InputSystem"));
    }
}
