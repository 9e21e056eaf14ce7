namespace NeuronMocap.Unity.Tests.InPackage;

/// <summary>Runs the tests inside the package, which are for users with an editor.</summary>
public sealed partial class InPackageTests
{
    public static TheoryData<string> PlayMode => PackageTest.Find("NeuronMocap.Unity.Tests.PlayMode");

    [Theory]
    [MemberData(nameof(PlayMode))]
    public void In_play_mode(string test) => PackageTest.Run("NeuronMocap.Unity.Tests.PlayMode", test, play: true);
}
