using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>The takes that are open, with the addresses below /api/takes.</summary>
internal interface ITakeLibrary : IViewPart
{
    /// <summary>Opens a file of this computer: the SOURCE of the command line, or a finished recording.</summary>
    /// <param name="path">The file.</param>
    /// <param name="order">Rotation order of a stream in the file; null for the order that the file states, or YXZ.</param>
    /// <param name="cancellationToken">Ends the wait.</param>
    /// <returns>The id of the take.</returns>
    /// <exception cref="ApiException">The file cannot be opened. The message is one sentence without its path.</exception>
    Task<string> OpenAsync(string path, RotationOrder? order, CancellationToken cancellationToken);

    /// <summary>Finds the performer with a key; null if no take has it.</summary>
    Task<TakePerformer?> FindPerformerAsync(string key, CancellationToken cancellationToken);
}
