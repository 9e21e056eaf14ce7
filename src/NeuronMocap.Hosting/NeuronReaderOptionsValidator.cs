using Microsoft.Extensions.Options;

namespace NeuronMocap.Hosting;

// Says at the host's start what the reader's constructor would say.
internal sealed class NeuronReaderOptionsValidator : IValidateOptions<NeuronReaderOptions>
{
    public ValidateOptionsResult Validate(string? name, NeuronReaderOptions options) =>
        options.FindFault() is { } fault ? ValidateOptionsResult.Fail(ReaderSettings.Prefix(name) + fault) : ValidateOptionsResult.Success;
}
