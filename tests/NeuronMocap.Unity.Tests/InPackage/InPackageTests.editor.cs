namespace NeuronMocap.Unity.Tests.InPackage;

public sealed partial class InPackageTests
{
    public static TheoryData<string> EditMode => PackageTest.Find("NeuronMocap.Unity.Tests.EditMode");

    [Theory]
    [MemberData(nameof(EditMode))]
    public void In_edit_mode(string test) => PackageTest.Run("NeuronMocap.Unity.Tests.EditMode", test, play: false);
}
