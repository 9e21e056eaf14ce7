using NeuronMocap.Unity.EditorTools;

namespace NeuronMocap.Unity.Tests.Editor;

public class AndroidManifestTests
{
    [Theory]
    [InlineData("<uses-permission android:name=\"android.permission.INTERNET\" />", true)]
    [InlineData("<uses-permission android:name='android.permission.INTERNET'></uses-permission>", true)]
    [InlineData("<uses-permission android:name=\"android.permission.INTERNET\" tools:node=\"merge\" />", true)]
    [InlineData("<uses-permission android:name=\"android.permission.INTERNET\" tools:node=\"remove\" />", false)]
    [InlineData("<uses-permission android:name=\"android.permission.ACCESS_NETWORK_STATE\" />", false)]
    [InlineData("<!-- <uses-permission android:name=\"android.permission.INTERNET\" /> -->", false)]
    [InlineData("<application><uses-permission android:name=\"android.permission.INTERNET\" /></application>", false)]
    [InlineData("", false)]
    public void The_permission_must_be_where_Android_reads_it(string content, bool expected)
    {
        string manifest = "<?xml version=\"1.0\" encoding=\"utf-8\"?><manifest xmlns:android=\"http://schemas.android.com/apk/res/android\" "
            + $"xmlns:tools=\"http://schemas.android.com/tools\" package=\"a.b\">{content}</manifest>";

        Assert.Equal(expected, AndroidManifest.HasInternetPermission(manifest));
        Assert.Equal(!expected, BuildRules.LacksInternetPermission(isForced: false, manifest));
        Assert.False(BuildRules.LacksInternetPermission(isForced: true, manifest));
    }

    [Theory]
    [InlineData("")]
    [InlineData("<manifest")]
    public void A_broken_manifest_has_none(string manifest)
    {
        Assert.False(AndroidManifest.HasInternetPermission(manifest));
    }

    [Fact]
    public void Without_a_manifest_the_player_setting_decides()
    {
        Assert.True(BuildRules.LacksInternetPermission(isForced: false, manifest: null));
        Assert.False(BuildRules.LacksInternetPermission(isForced: true, manifest: null));
    }
}
