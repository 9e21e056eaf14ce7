using Microsoft.Extensions.Options;

namespace NeuronMocap.Hosting;

// Reports at the host's start the errors that the reader's constructor would throw.
internal sealed class NeuronReaderOptionsValidator : IValidateOptions<NeuronReaderOptions>
{
    public ValidateOptionsResult Validate(string? name, NeuronReaderOptions options) =>
        options.Copy().FindFault() is { } fault ? ValidateOptionsResult.Fail(ReaderSettings.Prefix(name) + fault) : ValidateOptionsResult.Success;
}
