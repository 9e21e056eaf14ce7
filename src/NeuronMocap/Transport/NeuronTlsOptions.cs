using System.Security.Cryptography.X509Certificates;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>How a <see cref="NeuronReader"/> checks the certificate of a server that encrypts its stream with TLS.</summary>
/// <remarks>
/// Axis Neuron and Axis Studio do not use TLS. A server of the package NeuronMocap.AspNetCore, or a proxy in front of the server, does.
/// The system chooses the version of TLS.
/// </remarks>
public sealed class NeuronTlsOptions
{
    /// <summary>
    /// The name that the server's certificate must have. Null, the default, for <see cref="NeuronReaderOptions.Host"/>.
    /// </summary>
    public string? TargetHost { get; set; }

    /// <summary>
    /// A certificate to trust beside those that this computer trusts. Null, the default, for none. The reader does not dispose it, and needs it for each new
    /// connection.
    /// </summary>
    /// <remarks>
    /// It is either the certificate of the server, such as a self-signed one, or that of an authority. The server's own certificate is accepted for any
    /// name. A certificate that the authority has signed must have the name of the server. In both cases the certificate must be valid today.
    /// </remarks>
    public X509Certificate2? TrustedCertificate { get; set; }

    // Programs of machine code without these options, such as the native library, then contain no TLS, which is 3 MB.
    internal Func<LinkOptions, NeuronTlsOptions, TcpReceiver> CreateReceiver { get; } = static (options, tls) => new TlsReceiver(options, tls);

    internal NeuronTlsOptions Copy() => (NeuronTlsOptions)MemberwiseClone();

    // For a connection to an address of the host.
    internal NeuronTlsOptions For(string host)
    {
        NeuronTlsOptions copy = Copy();
        copy.TargetHost ??= host;
        return copy;
    }

    internal string? FindFault() => TargetHost is not null && string.IsNullOrWhiteSpace(TargetHost)
        ? "Tls.TargetHost is empty; give the name in the server's certificate, or leave it null."
        : null;
}
