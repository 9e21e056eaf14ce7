using System.Diagnostics;
using System.Globalization;
using System.Net.WebSockets;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.AspNetCore.Routing;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>The characters of all pages: /api/characters, and a socket with poses for each of them. Thread-safe.</summary>
/// <param name="live">The stream; null if a take is open instead.</param>
/// <param name="takes">The takes.</param>
internal sealed class CharacterLibrary(LiveSession? live, ITakeLibrary takes) : IViewPart
{
    /// <summary>Number of characters. A further one replaces the one that no page has used for the longest time.</summary>
    public const int MostCharacters = 64;

    // A node with its numbers has about two hundred bytes.
    private const long LargestBody = 4 * BodyLimit.Megabyte;
    private const int MostListeners = 16;

    private static readonly TimeSpan KeepAliveInterval = TimeSpan.FromSeconds(15);

    private readonly Lock _lock = new();
    private readonly Dictionary<uint, CharacterMotion> _characters = [];

    // Pages outlive the program. A page of an earlier run must not find the character of another page under the number of its own.
    private uint _last = (uint)RandomNumberGenerator.GetInt32(int.MaxValue);

    public void Map(IEndpointRouteBuilder endpoints)
    {
        endpoints.MapPost("/api/characters", AddAsync).WithMetadata(new BodyLimit(LargestBody));
        endpoints.MapPut("/api/characters/{id}", ChangeAsync);
        endpoints.MapDelete("/api/characters/{id}", RemoveAsync);
        endpoints.MapGet("/api/takes/{id}/characters/{character}/poses", SendPosesAsync);
        IApplicationBuilder application = endpoints.CreateApplicationBuilder()
            .Use(LimitedInput.InsertAsync)
            .UseWebSockets(new WebSocketOptions { KeepAliveInterval = KeepAliveInterval });
        application.Run(ServeAsync);
        endpoints.Map("/characters/{id}/motion", application.Build());
    }

    /// <summary>Finds a character.</summary>
    /// <exception cref="ApiException">There is none with this number.</exception>
    public CharacterMotion Find(string? id)
    {
        lock (_lock)
        {
            bool isNumber = uint.TryParse(id, NumberStyles.None, CultureInfo.InvariantCulture, out uint number);
            if (!isNumber || !_characters.TryGetValue(number, out CharacterMotion? motion))
                throw ApiException.NotFound("The program does not know this character any more. Drop it on the page again.");

            motion.LastUse = Stopwatch.GetTimestamp();
            return motion;
        }
    }

    public ValueTask DisposeAsync()
    {
        lock (_lock)
        {
            foreach (CharacterMotion motion in _characters.Values)
                motion.End(WebSocketCloseStatus.EndpointUnavailable, "The server stops.");

            _characters.Clear();
        }

        return ValueTask.CompletedTask;
    }

    private async Task AddAsync(HttpContext context)
    {
        NewCharacterJson request = await ApiJson.ReadAsync<NewCharacterJson>(context);
        var motion = new CharacterMotion(new Character(Interlocked.Increment(ref _last), request), live);
        lock (_lock)
        {
            MakeRoom();
            _characters.Add(motion.Character.Id, motion);
        }

        await ApiJson.WriteAsync(context, motion.Character.Describe());
    }

    private async Task ChangeAsync(HttpContext context)
    {
        Character character = Find(context).Character;
        character.Change(await ApiJson.ReadAsync<CharacterChangeJson>(context));
        await ApiJson.WriteAsync(context, character.Describe());
    }

    private Task RemoveAsync(HttpContext context)
    {
        CharacterMotion motion = Find(context);
        lock (_lock)
            _characters.Remove(motion.Character.Id);

        motion.End(WebSocketCloseStatus.NormalClosure, "The character was removed.");
        context.Response.StatusCode = StatusCodes.Status204NoContent;
        return Task.CompletedTask;
    }

    private async Task SendPosesAsync(HttpContext context)
    {
        Character character = Find(context.GetRouteValue("character") as string).Character;
        string key = context.Request.Query["performer"].ToString();
        TakePerformer performer = await takes.FindPerformerAsync(key, context.RequestAborted) ?? throw ApiException.NotFound("No open take has this performer.");
        long first = TakeRequest.GetNumber(context, "from", usual: 0, least: 0, most: long.MaxValue / 2);
        int count = (int)TakeRequest.GetNumber(context, "count", usual: 1, least: 1, CharacterTake.MostFrames);
        await new CharacterTake(character, performer).SendAsync(context, first, count);
    }

    private async Task ServeAsync(HttpContext context)
    {
        if (!context.WebSockets.IsWebSocketRequest)
            throw ApiException.BadRequest("This address is a WebSocket.");

        CharacterMotion motion = Find(context);
        if (motion.Listeners >= MostListeners)
            throw new ApiException(StatusCodes.Status503ServiceUnavailable, "Too many pages show this character.");

        using LimitedInput input = context.Features.GetRequiredFeature<LimitedInput>();
        using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync();
        var listener = new CharacterListener(socket, input, context);
        motion.Add(listener);
        try
        {
            CancellationToken stopping = context.RequestServices.GetRequiredService<IHostApplicationLifetime>().ApplicationStopping;
            using (stopping.Register(() => listener.End(WebSocketCloseStatus.EndpointUnavailable, "The server stops.")))
                await listener.RunAsync();
        }
        finally
        {
            motion.Remove(listener);
            motion.LastUse = Stopwatch.GetTimestamp();
        }
    }

    private CharacterMotion Find(HttpContext context) => Find(context.GetRouteValue("id") as string);

    // Pages that were closed do not say which characters they had.
    private void MakeRoom()
    {
        if (_characters.Count < MostCharacters)
            return;

        CharacterMotion oldest = _characters.Values.Where(static motion => motion.Listeners == 0).MinBy(static motion => motion.LastUse)
            ?? throw ApiException.Conflict($"The pages show {MostCharacters} characters already. Remove one.");
        _characters.Remove(oldest.Character.Id);
    }
}
