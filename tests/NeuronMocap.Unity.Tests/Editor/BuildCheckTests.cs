using NeuronMocap.Unity.EditorTools;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class BuildCheckTests : IDisposable
{
    private readonly EditorWorld _world = new();
    private readonly NeuronMocapSettings _settings = NeuronMocapSettings.instance;
    private readonly string _folder = Directory.CreateTempSubdirectory("neuronmocap").FullName;

    public BuildCheckTests() => PlayerSettings.Android.forceInternetPermission = false;

    public void Dispose()
    {
        Directory.Delete(_folder, recursive: true);
        (_settings.AddLocalNetworkText, _settings.LocalNetworkText) = (true, NeuronMocapSettings.DefaultLocalNetworkText);
        (_settings.RequireInternetPermission, _settings.WebGL) = (true, BuildProblem.Warn);
        PlayerSettings.Android.forceInternetPermission = false;
        _world.Dispose();
    }

    [Theory]
    [InlineData(BuildTarget.iOS)]
    [InlineData(BuildTarget.tvOS)]
    [InlineData(BuildTarget.VisionOS)]
    public void A_build_for_a_device_of_Apple_adds_the_text_once(BuildTarget target)
    {
        string path = WritePlist();
        var checks = new BuildChecks();
        checks.OnPostprocessBuild(BuildReport.Of(target, _folder));
        string once = File.ReadAllText(path);
        checks.OnPostprocessBuild(BuildReport.Of(target, _folder));

        Assert.Contains(NeuronMocapSettings.DefaultLocalNetworkText, once, StringComparison.Ordinal);
        Assert.Equal(once, File.ReadAllText(path));
        Assert.Empty(ConsoleLog.Problems);
    }

    [Theory]
    [InlineData(true, " ", BuildRules.MissingTextAdvice)]
    [InlineData(false, "Text.", BuildRules.TextNotAddedAdvice)]
    public void An_iOS_build_without_a_text_warns(bool adds, string text, string advice)
    {
        string path = WritePlist();
        (_settings.AddLocalNetworkText, _settings.LocalNetworkText) = (adds, text);
        new BuildChecks().OnPostprocessBuild(BuildReport.Of(BuildTarget.iOS, _folder));

        Assert.Equal(advice, Assert.Single(ConsoleLog.Problems).Message);
        Assert.False(InfoPlist.HasLocalNetworkText(File.ReadAllText(path)));
    }

    [Fact]
    public void An_unreadable_Info_plist_is_explained()
    {
        new BuildChecks().OnPostprocessBuild(BuildReport.Of(BuildTarget.iOS, _folder));

        Assert.Contains("Add it in Xcode", Assert.Single(ConsoleLog.Problems).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Builds_for_other_platforms_are_left_alone()
    {
        string path = WritePlist();
        string before = File.ReadAllText(path);
        var checks = new BuildChecks();
        checks.OnPreprocessBuild(BuildReport.Of(BuildTarget.StandaloneOSX, _folder));
        checks.OnPostprocessBuild(BuildReport.Of(BuildTarget.StandaloneOSX, _folder));

        Assert.Equal(before, File.ReadAllText(path));
        Assert.False(PlayerSettings.Android.forceInternetPermission);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void An_Android_build_adds_and_reports_the_permission_once()
    {
        var checks = new BuildChecks();
        checks.OnPreprocessBuild(BuildReport.Of(BuildTarget.Android));
        checks.OnPreprocessBuild(BuildReport.Of(BuildTarget.Android));

        Assert.True(PlayerSettings.Android.forceInternetPermission);
        Assert.Equal(BuildRules.PermissionSet, Assert.Single(ConsoleLog.Entries).Message);
    }

    [Fact]
    public void An_Android_build_without_the_permission_warns_if_it_may_not_be_set()
    {
        _settings.RequireInternetPermission = false;
        new BuildChecks().OnPreprocessBuild(BuildReport.Of(BuildTarget.Android));

        Assert.False(PlayerSettings.Android.forceInternetPermission);
        Assert.Equal(BuildRules.PermissionAdvice, Assert.Single(ConsoleLog.Problems).Message);
    }

    [Fact]
    public void A_source_in_a_WebGL_build_warns_by_name()
    {
        _world.AddSource(static _ => { }, "Stage Left");
        Process(BuildTarget.WebGL);

        LogEntry warning = Assert.Single(ConsoleLog.Problems);
        Assert.Equal(LogType.Warning, warning.Type);
        Assert.Contains("'Stage Left'", warning.Message, StringComparison.Ordinal);
        Assert.Contains("platforms.md", warning.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_source_in_a_WebGL_build_can_fail_or_be_ignored()
    {
        _world.AddSource(static _ => { });
        _settings.WebGL = BuildProblem.Fail;
        Assert.Throws<BuildFailedException>(() => Process(BuildTarget.WebGL));

        _settings.WebGL = BuildProblem.Ignore;
        Process(BuildTarget.WebGL);
        Assert.Empty(ConsoleLog.Problems);
    }

    [Fact]
    public void Scenes_of_other_builds_and_play_mode_are_not_checked()
    {
        _world.AddSource(static _ => { });
        _settings.WebGL = BuildProblem.Fail;
        Process(BuildTarget.StandaloneWindows64);
        new BuildChecks().OnProcessScene(SceneManager.GetActiveScene(), null);

        Assert.Empty(ConsoleLog.Problems);
    }

    [Fact]
    public void Settings_round_trip_through_their_file()
    {
        const string File = "ProjectSettings/NeuronMocap.asset";
        try
        {
            SettingsProvider page = SettingsPage.Create();
            Assert.Equal(("Project/NeuronMocap", SettingsScope.Project), (page.settingsPath, page.scope));
            ImmediateGui.Set(() => page.guiHandler!(""), "Local Network Text", "For the show: 100 % live.");
            Assert.True(System.IO.File.Exists(File));

            _settings.LocalNetworkText = "Not saved.";
            NeuronMocapSettings.Forget();
            Assert.Equal("For the show: 100 % live.", NeuronMocapSettings.instance.LocalNetworkText);
            Assert.True(NeuronMocapSettings.instance.AddLocalNetworkText);
        }
        finally
        {
            System.IO.File.Delete(File);
            NeuronMocapSettings.Forget();
        }
    }

    [Fact]
    public void The_guide_describes_every_setting_and_its_default()
    {
        string guide = File.ReadAllText(Path.Combine(Repository.Root, "unity-package", "Documentation~", "platforms.md"));
        ImmediateGui.Draw(() => SettingsPage.Draw(_settings));

        GuiControl[] fields = [.. EditorWorld.Controls.Where(static control => control.Kind == "Property")];
        Assert.Equal(4, fields.Length);
        Assert.All(fields, field => Assert.Matches($@"(?m)^\| {field.Label} \| .* \| \*?{System.Text.RegularExpressions.Regex.Escape(field.Value)}\*? \|$", guide));
    }

    [Fact]
    public void The_page_warns_of_an_empty_text_and_greys_it_out_when_it_is_not_added()
    {
        _settings.LocalNetworkText = "";
        ImmediateGui.Draw(() => SettingsPage.Draw(_settings));
        Assert.Equal("Warning", EditorWorld.Find(BuildRules.MissingTextAdvice).Value);

        _settings.AddLocalNetworkText = false;
        ImmediateGui.Draw(() => SettingsPage.Draw(_settings));
        Assert.False(EditorWorld.Find("Local Network Text").Tooltip.Length == 0);
        Assert.False(EditorWorld.Controls.Single(static control => control.Label == "Local Network Text").IsEnabled);
    }

    private static void Process(BuildTarget target) => new BuildChecks().OnProcessScene(SceneManager.GetActiveScene(), BuildReport.Of(target));

    private string WritePlist()
    {
        string path = Path.Combine(_folder, "Info.plist");
        File.WriteAllText(path, "<plist version=\"1.0\"><dict><key>A</key><true/></dict></plist>");
        return path;
    }
}
