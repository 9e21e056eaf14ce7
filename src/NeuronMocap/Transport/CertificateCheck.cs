using System.Net.Security;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;

namespace NeuronMocap.Transport;

// Decides whether the certificate of a server is accepted, and keeps the reason if not. One connection, one check.
internal sealed class CertificateCheck(string target, NeuronTlsOptions options)
{
    private const string ServerAuthentication = "1.3.6.1.5.5.7.3.1";

    // Why the certificate was rejected; null if it was accepted.
    public string? Fault { get; private set; }

    public bool Accepts(object sender, X509Certificate? certificate, X509Chain? chain, SslPolicyErrors errors)
    {
        Fault = Find(certificate, chain, errors);
        return Fault is null;
    }

    private string? Find(X509Certificate? certificate, X509Chain? chain, SslPolicyErrors errors)
    {
        if (errors == SslPolicyErrors.None)
            return null;
        if (certificate is null)
            return $"{target} has no certificate.";

        using var server = new X509Certificate2(certificate);
        if (DateTime.Now > server.NotAfter)
            return FormattableString.Invariant($"The certificate of {target} expired on {server.NotAfter:yyyy-MM-dd}. Renew it on the server, or check the clock of this computer.");
        if (DateTime.Now < server.NotBefore)
            return FormattableString.Invariant($"The certificate of {target} is not valid before {server.NotBefore:yyyy-MM-dd}. Check the clock of this computer.");

        if (options.TrustedCertificate is { } trusted)
        {
            if (IsSame(server, trusted))
                return null;
            if (IsSignedBy(trusted, server, chain))
                errors &= ~SslPolicyErrors.RemoteCertificateChainErrors;
        }

        if ((errors & SslPolicyErrors.RemoteCertificateChainErrors) != SslPolicyErrors.None)
            return DescribeChain(server, chain);

        return (errors & SslPolicyErrors.RemoteCertificateNameMismatch) == SslPolicyErrors.None
            ? null
            : $"The certificate of {target} is for another name: {DescribeNames(server)}. Connect by that name, or set Tls.TargetHost to it.";
    }

    private string DescribeChain(X509Certificate2 server, X509Chain? chain)
    {
        bool isUnknown = chain is null || chain.ChainStatus.Any(static status =>
            (status.Status & (X509ChainStatusFlags.UntrustedRoot | X509ChainStatusFlags.PartialChain)) != X509ChainStatusFlags.NoError);
        if (!isUnknown)
            return $"The certificate of {target} is not valid: {string.Join(" ", chain!.ChainStatus.Select(static status => status.StatusInformation.Trim()))}";

        string signer = server.SubjectName.RawData.AsSpan().SequenceEqual(server.IssuerName.RawData)
            ? "is self-signed, and this computer does not trust it"
            : $"was issued by {server.GetNameInfo(X509NameType.SimpleName, forIssuer: true)}, which this computer does not trust";
        return $"The certificate of {target} {signer}. If it is yours, set Tls.TrustedCertificate.";
    }

    private static string DescribeNames(X509Certificate2 server) => server.GetNameInfo(X509NameType.DnsName, forIssuer: false) is { Length: > 0 } name ? name : server.Subject;

    // .NET Standard has no trust store of one's own, so this builds a chain that may end anywhere, and then looks for the authority in it.
    private static bool IsSignedBy(X509Certificate2 authority, X509Certificate2 server, X509Chain? presented)
    {
        using var chain = new X509Chain();
        chain.ChainPolicy.RevocationMode = X509RevocationMode.NoCheck;
        chain.ChainPolicy.VerificationFlags = X509VerificationFlags.AllowUnknownCertificateAuthority;
        chain.ChainPolicy.ApplicationPolicy.Add(new Oid(ServerAuthentication));
        chain.ChainPolicy.ExtraStore.Add(authority);
        foreach (X509ChainElement element in presented?.ChainElements.Cast<X509ChainElement>() ?? [])
            chain.ChainPolicy.ExtraStore.Add(element.Certificate);

        return chain.Build(server) && chain.ChainElements.Cast<X509ChainElement>().Skip(1).Any(element => IsSame(element.Certificate, authority));
    }

    private static bool IsSame(X509Certificate2 one, X509Certificate2 other) => one.RawData.AsSpan().SequenceEqual(other.RawData);
}
