#nullable enable

using System;

namespace NeuronMocap.Unity
{
    // The library's messages, with the names of inspector fields instead of options.
    internal static class StatusText
    {
        public const string Closed = "Closed. Enable the component, or call Open.";

        public const string Browser =
            "A web browser provides neither sockets nor threads, so nothing can be received in a WebGL build. Build for desktop or mobile, or relay the "
            + "motion to the page: see the page on platforms in the package's documentation.";

        private static readonly (string Option, string Field)[] Names =
        {
            ("(CommandPort)", "(Command Port)"),
            ("CommandPort", "Command Port"),
            ("CalculationPort", "Calculation Port"),
            ("LocalAddress", "Local Address"),
            ("RotationOrder", "Rotation Order"),
            ("SkeletonVariant", "Skeleton Variant"),
            ("Host is empty", "Address is empty"),
            ("ConnectTimeout", "connect timeout"),
        };

        // Before there is a reader. For the network, as the library says it.
        public static string OfOpening(SourceSettings settings) => settings.IsFile ? "Reading the file." : $"Connecting to {settings.Target}.";

        public static string Of(SourceConnection connection, in ConnectionStatus status)
        {
            SourceSettings settings = connection.Settings;
            switch (settings.Kind)
            {
                case SourceKind.Recording:
                case SourceKind.BvhFile:
                    return status.Reason == ConnectionReason.EndOfRecording && status.State == ConnectionState.Stopped
                        ? $"The {settings.Target} has ended. Switch Loop on to repeat it."
                        : WithFields(status.Message).Replace($"motion {settings.Name}", settings.Target);
                default:
                    return WithFields(status.Message);
            }
        }

        public static string OfFault(SourceSettings settings, Exception exception)
        {
            string what = WithFields(exception.Message);
            return settings.Kind switch
            {
                SourceKind.Network => $"{what} Change it in the inspector of the source.",
                SourceKind.Simulator => $"The simulator did not start: {what}",
                _ when settings.Asset is null && settings.File.Length == 0 => "File is empty. Enter the path of a file, absolute or relative to StreamingAssets.",
                _ when settings.Asset is null && settings.File.Contains("://") =>
                    $"The {settings.Target} lies inside the application's package, where it cannot be opened as a file. Assign it as a text asset (BVH Asset), or copy it "
                    + "to Application.persistentDataPath first.",
                _ => $"The {settings.Target} cannot be played: {what}",
            };
        }

        private static string WithFields(string message)
        {
            // The message of an ArgumentException ends with the name of its parameter.
            int parameter = message.IndexOf(" (Parameter", StringComparison.Ordinal);
            if (parameter >= 0)
                message = message.Substring(0, parameter);

            foreach ((string option, string field) in Names)
                message = message.Replace(option, field);

            return message;
        }
    }
}
