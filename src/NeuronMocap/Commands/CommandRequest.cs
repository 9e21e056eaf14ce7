using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

// Converts a payload to an answer, or throws a NeuronCommandException.
internal delegate T ReplyParser<T>(ReadOnlySpan<byte> payload);

// One call, from start to end.
internal abstract class CommandRequest(CommandChannelId? id, int? avatar)
{
    // Null for a call that only connects.
    public CommandChannelId? Id => id;

    public CancellationTokenRegistration Cancellation { get; set; }

    public abstract bool IsCompleted { get; }

    public byte[] Encode()
    {
        int payloadSize = avatar is null ? 0 : sizeof(int);
        byte[] packet = new byte[CommandChannelHeader.Size + payloadSize];
        new CommandChannelHeader { CommandId = (ushort)id!.Value, PayloadSize = payloadSize }.Write(packet);
        if (avatar is { } index)
            BinaryPrimitives.WriteInt32LittleEndian(packet.AsSpan(CommandChannelHeader.Size), index);

        return packet;
    }

    public abstract void Complete(ReadOnlySpan<byte> payload);

    public abstract bool Fail(Exception exception);

    public abstract bool Cancel(CancellationToken cancellationToken);
}

internal sealed class CommandRequest<T>(CommandChannelId? id, int? avatar, ReplyParser<T> parse) : CommandRequest(id, avatar)
{
    // Returned to the caller directly. A caller that blocks on this task is woken by the thread that completes it, and needs no pool thread.
    private readonly TaskCompletionSource<T> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public Task<T> Task => _completion.Task;

    public override bool IsCompleted => _completion.Task.IsCompleted;

    public override void Complete(ReadOnlySpan<byte> payload) => _completion.TrySetResult(parse(payload));

    public override bool Fail(Exception exception) => _completion.TrySetException(exception);

    public override bool Cancel(CancellationToken cancellationToken) => _completion.TrySetCanceled(cancellationToken);
}
