namespace NeuronMocap.Transport;

// Describes the stream for the status. Text completes a sentence that says where the stream comes from. A reason other than None is the problem with the
// stream.
internal readonly record struct StreamDescription(StreamFormat Format, ConnectionReason Reason, string? Text);
