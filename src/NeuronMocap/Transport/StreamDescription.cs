namespace NeuronMocap.Transport;

// What arrives, for the status: the text completes a sentence that says from where. A reason other than None is what is wrong with it.
internal readonly record struct StreamDescription(StreamFormat Format, ConnectionReason Reason, string? Text);
