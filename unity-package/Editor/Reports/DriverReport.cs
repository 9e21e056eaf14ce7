#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // Whether a figure moves, which performer it follows, and why it does not move.
    internal sealed class DriverReport
    {
        private DriverReport(Severity severity, string title, string message)
        {
            Severity = severity;
            Title = title;
            Message = message;
        }

        public Severity Severity { get; }

        public string Title { get; }

        public string Message { get; }

        public static DriverReport Of(FigureDriver driver, bool isPlaying)
        {
            if (driver.IsPosed)
                return new DriverReport(Severity.Good, "Moved by Timeline", string.Empty);
            if (!isPlaying && !driver.IsPreviewed)
                return new DriverReport(Severity.None, "Moves in play mode, and in the preview of its source", string.Empty);
            if (!driver.isActiveAndEnabled)
                return new DriverReport(Severity.None, "Disabled", string.Empty);
            if (driver.Problem.Length > 0)
                return new DriverReport(Severity.Error, "The figure does not move", driver.Problem);

            return driver.IsDriving
                ? new DriverReport(Severity.Good, $"Follows {driver.Performer}", driver.RestPoseNote)
                : new DriverReport(Severity.Waiting, "Waiting for its performer", string.Empty);
        }
    }
}
