using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.View.Actions;

/// <summary>POST /api/record: starts and stops recordings for all pages. A finished recording is opened as a take. Thread-safe.</summary>
internal sealed class RecordingControl : IViewPart
{
    private readonly Lock _lock = new();
    private readonly NeuronReader _reader;
    private readonly TakeRecorder _takes;
    private readonly ControlHub _hub;
    private readonly ITakeLibrary? _library;

    // The pages are told without the lock, because a start of a recording can wait for a disk and for a thread that sends.
    private volatile Watch.Recordings.Take? _newest;
    private volatile RecordingMessage[] _finished = [];

    /// <summary>Creates the control, without a recording.</summary>
    /// <param name="reader">The reader to record.</param>
    /// <param name="folder">The folder for the files; empty for the current one.</param>
    /// <param name="hub">The pages.</param>
    /// <param name="library">Opens finished recordings; null for nobody.</param>
    public RecordingControl(NeuronReader reader, string folder, ControlHub hub, ITakeLibrary? library)
    {
        (_reader, _takes, _hub, _library) = (reader, new TakeRecorder(reader, settings: null, folder), hub, library);
        reader.EventReported += OnEvent;
    }

    public void Map(IEndpointRouteBuilder endpoints) => endpoints.MapPost("/api/record", HandleAsync);

    /// <summary>Describes the running recording, or that there is none.</summary>
    public RecordingMessage Describe() => _newest is { IsRecording: true } take ? RecordingMessage.Of(take, _takes.FramesArrived) : RecordingMessage.None;

    /// <summary>Makes the messages for a new page: the finished recordings, then the running one.</summary>
    public IReadOnlyList<object> Greet() => [.. _finished, Describe()];

    /// <summary>Tells the pages how the recording grows. Called once a second.</summary>
    public void Report() => _hub.SendCurrent(() => Describe() is { State: RecordingMessage.Recording } message ? message : null);

    /// <summary>Closes the files and reports each recording on standard error. The reader has ended before.</summary>
    /// <returns>Whether all recordings are complete.</returns>
    public Task<bool> FinishAsync(StandardStreams streams)
    {
        lock (_lock)
            return _takes.FinishAsync(streams);
    }

    public ValueTask DisposeAsync()
    {
        _reader.EventReported -= OnEvent;
        return ValueTask.CompletedTask;
    }

    private async Task HandleAsync(HttpContext context)
    {
        RecordingMessage message = (await ApiJson.ReadAsync<RequestJson>(context)).Action switch
        {
            "start" => Start(),
            "stop" => await StopAsync(),
            _ => throw ApiException.BadRequest("The action of a recording is start or stop."),
        };
        await ApiJson.WriteAsync(context, message);
    }

    private RecordingMessage Start()
    {
        RecordingMessage message;
        lock (_lock)
        {
            if (_takes.Current is not null)
                throw ApiException.Conflict("A recording is running already.");
            if (_takes.Begin(DateTime.Now) is { } failure)
                throw ApiException.Conflict(failure.Text);

            // It can have failed already.
            Watch.Recordings.Take take = _takes.Takes[^1];
            _newest = take;
            message = RecordingMessage.Of(take, _takes.FramesArrived);
        }

        _hub.SendCurrent(Describe);
        return message;
    }

    // A page that leaves meanwhile cancels nothing: the others wait for the end.
    private async Task<RecordingMessage> StopAsync()
    {
        Watch.Recordings.Take take;
        Task closed;
        lock (_lock)
        {
            take = _takes.Current ?? throw ApiException.Conflict("No recording is running.");
            closed = take.StopAsync(_takes.FramesArrived);
        }

        await closed;
        RecordingMessage message = RecordingMessage.Of(take, _takes.FramesArrived) with { State = RecordingMessage.Idle, Take = await OpenAsync(take.Recorder) };
        lock (_lock)
            _finished = [.. _finished, message];

        _hub.Send(message);
        if (message.Take is { } id)
            _hub.Send(new TakeMessage(id));

        // Another recording may have started meanwhile.
        Report();
        return message;
    }

    private async Task<string?> OpenAsync(StreamRecorder recorder)
    {
        if (_library is null)
            return null;

        try
        {
            return await _library.OpenAsync(recorder.CurrentPath, order: null, CancellationToken.None);
        }
        catch (ApiException exception)
        {
            _hub.Send(new ProblemMessage(exception.Message));
            return null;
        }
    }

    // The disk is full, for example. The stream goes on.
    private void OnEvent(ReaderEvent news)
    {
        if (FileFailure.Of(news) is not { } failure)
            return;

        _hub.Send(new ProblemMessage(failure.Text));
        _hub.SendCurrent(Describe);
    }

    private sealed record RequestJson(string? Action);
}
