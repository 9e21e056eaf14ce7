namespace NeuronMocap.Unity.Tests.InPackage;

/// <summary>The tests inside the package, for those who have an editor, run here as well.</summary>
public sealed partial class InPackageTests
{
    public static TheoryData<string> PlayMode => PackageTest.Find("NeuronMocap.Unity.Tests.PlayMode");

    [Theory]
    [MemberData(nameof(PlayMode))]
    public void In_play_mode(string test) => PackageTest.Run("NeuronMocap.Unity.Tests.PlayMode", test, play: true);
}
