using Microsoft.AspNetCore.Http;

namespace NeuronMocap.Tool.View.Web;

/// <summary>A new folder for files that pages send, and for what is made of them. It is deleted at the end. Thread-safe.</summary>
/// <remarks>Names of files never come from outside, so nothing can be written anywhere else. On Unix only this user can read the folder.</remarks>
/// <param name="mostBytes">The largest size of all saved files together, in bytes.</param>
internal sealed class ScratchFolder(long mostBytes) : IDisposable
{
    private const int BufferSize = 128 * 1024;

    private readonly ScratchLease _lease = ScratchLease.Take();
    private readonly Dictionary<string, long> _sizes = new(StringComparer.Ordinal);
    private readonly Lock _lock = new();

    /// <summary>The folder.</summary>
    public string Path => _lease.Path;

    /// <summary>Makes a name for a file in the folder. Only files with such names are deleted when a program that was killed has left them.</summary>
    public static string NewName() => Guid.NewGuid().ToString("N");

    /// <summary>Saves the body of a request as a new file.</summary>
    /// <param name="body">The body. Kestrel limits its size: see <see cref="BodyLimit"/>.</param>
    /// <param name="cancellationToken">Ends the saving, and deletes the file.</param>
    /// <returns>The path of the file.</returns>
    /// <exception cref="ApiException">There is no room.</exception>
    public async Task<string> SaveAsync(Stream body, CancellationToken cancellationToken)
    {
        string path = System.IO.Path.Combine(Path, NewName());
        try
        {
            var file = new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.Read, bufferSize: 1, useAsync: true);
            await using (file)
                await CopyAsync(body, file, path, cancellationToken);

            return path;
        }
        catch (Exception exception)
        {
            Delete(path);
            if (IsOfDisk(exception))
                throw new ApiException(StatusCodes.Status507InsufficientStorage, "The file could not be saved: the disk of the program's computer may be full.");

            throw;
        }
    }

    /// <summary>Whether an exception says that a disk is full or fails. A file that is too large for its disk is an argument out of range.</summary>
    public static bool IsOfDisk(Exception exception) => exception is ArgumentOutOfRangeException or IOException and not BadHttpRequestException;

    /// <summary>Deletes a saved file.</summary>
    public void Delete(string path)
    {
        lock (_lock)
            _sizes.Remove(path);

        try
        {
            File.Delete(path);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // Something still reads it. The whole folder is deleted at the end.
        }
    }

    public void Dispose() => _lease.Dispose();

    private async Task CopyAsync(Stream body, FileStream file, string path, CancellationToken cancellationToken)
    {
        byte[] buffer = new byte[BufferSize];
        int length;
        while ((length = await body.ReadAsync(buffer, cancellationToken)) > 0)
        {
            Reserve(path, length);
            await file.WriteAsync(buffer.AsMemory(0, length), cancellationToken);
        }
    }

    private void Reserve(string path, int length)
    {
        lock (_lock)
        {
            if (_sizes.Values.Sum() + length > mostBytes)
            {
                throw new ApiException(
                    StatusCodes.Status507InsufficientStorage, "There is no room for another file. Close the program and start it again to empty its folder.");
            }

            _sizes[path] = _sizes.GetValueOrDefault(path) + length;
        }
    }
}
