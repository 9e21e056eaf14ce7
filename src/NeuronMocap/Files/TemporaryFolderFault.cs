namespace NeuronMocap.Files;

// What to tell users when a temporary file cannot be created, written or read. Its name would mean nothing to them.
internal static class TemporaryFolderFault
{
    public static string Describe()
    {
        string variable = OperatingSystem.IsWindows() ? "TMP" : "TMPDIR";
        return $"The folder for temporary files, '{Path.GetTempPath()}', cannot be used: it does not exist, its disk is full, or this user may not write there. "
            + $"Set {variable} to another folder.";
    }
}
