namespace UnityEditor;

public class SettingsProvider(string path, SettingsScope scopes, IEnumerable<string>? keywords = null)
{
    public string settingsPath { get; } = path;

    public SettingsScope scope { get; } = scopes;

    public string label { get; set; } = "";

    public IEnumerable<string> keywords { get; set; } = keywords ?? [];

    public Action<string>? guiHandler { get; set; }
}
