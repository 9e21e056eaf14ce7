namespace NeuronMocap.Tool.View.Characters;

/// <summary>A character cannot be driven. The message is the reason: the end of a sentence, after a colon.</summary>
internal sealed class CharacterException(string message) : Exception(message);
