using System.Windows.Forms;

// The SDK generates this class for .NET. On .NET Framework, app.config and app.manifest set the mode for high resolutions.
internal static class ApplicationConfiguration
{
    public static void Initialize()
    {
        Application.EnableVisualStyles();
        Application.SetCompatibleTextRenderingDefault(false);
    }
}
