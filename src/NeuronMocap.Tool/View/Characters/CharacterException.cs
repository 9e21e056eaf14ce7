namespace NeuronMocap.Tool.View.Characters;

/// <summary>A character cannot be driven. The message is one sentence for the person who dropped it on the page.</summary>
internal sealed class CharacterException(string message) : Exception(message);
