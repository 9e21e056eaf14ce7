/** What a request says that got no answer. */
export const NoAnswer = "The program does not answer.";

const TokenName = "neuron-mocap-token";

/** Requests to the server of the page, with the token that came in the page's address. */
export class Api {
  private readonly _token: string | null;

  constructor() {
    const address = new URL(location.href);
    const given = address.searchParams.get("token");
    this._token = given ?? readToken();
    if (given === null || !keepToken(given))
      return;

    // Out of the address, so that no picture of the screen shows it. A reload of the tab finds it again.
    address.searchParams.delete("token");
    history.replaceState(null, "", address);
  }

  /** The answer of a request. Throws an ApiError with the server's sentence if it refuses. */
  async send(path: string, init: RequestInit = {}): Promise<Response> {
    const headers = new Headers(init.headers);
    if (this._token !== null)
      headers.set("Authorization", `Bearer ${this._token}`);

    let answer: Response;
    try {
      answer = await fetch(`api/${path}`, { ...init, headers, cache: "no-store" });
    } catch (error) {
      if ((error as Error).name === "AbortError")
        throw error;
      throw new ApiError(0, NoAnswer);
    }

    if (!answer.ok)
      throw new ApiError(answer.status, sentenceOf(await answer.text(), answer.status));
    return answer;
  }

  async get<T>(path: string, signal?: AbortSignal): Promise<T> {
    return (await this.send(path, { signal })).json() as Promise<T>;
  }

  async bytes(path: string, signal?: AbortSignal): Promise<ArrayBuffer> {
    return (await this.send(path, { signal })).arrayBuffer();
  }

  /** Sends a value as JSON. */
  async change<T>(method: "POST" | "PUT" | "DELETE", path: string, value?: unknown): Promise<T | null> {
    const answer = await this.send(path, {
      method,
      body: value === undefined ? undefined : JSON.stringify(value),
      headers: value === undefined ? {} : { "Content-Type": "application/json" },
    });
    const text = await answer.text();
    return text === "" ? null : JSON.parse(text) as T;
  }

  /** Sends a file, and tells how much of it has left: 0 to 1. fetch does not know that. */
  upload<T>(path: string, file: Blob, progress: (part: number) => void, signal: AbortSignal): Promise<T> {
    return new Promise((resolve, reject) => {
      const request = new XMLHttpRequest();
      request.open("POST", `api/${path}`);
      if (this._token !== null)
        request.setRequestHeader("Authorization", `Bearer ${this._token}`);
      request.upload.addEventListener("progress", event => progress(event.loaded / Math.max(1, event.total)));
      request.addEventListener("load", () => {
        if (request.status >= 200 && request.status < 300)
          resolve(JSON.parse(request.responseText) as T);
        else
          reject(new ApiError(request.status, sentenceOf(request.responseText, request.status)));
      });
      request.addEventListener("error", () => reject(new ApiError(0, NoAnswer)));
      request.addEventListener("abort", () => reject(new DOMException("The upload was cancelled.", "AbortError")));
      signal.addEventListener("abort", () => request.abort());
      request.send(file);
    });
  }

  /** Opens a WebSocket of the server. */
  socket(path: string, protocol?: string): WebSocket {
    const address = new URL(path, document.baseURI);
    address.protocol = address.protocol.replace("http", "ws");
    if (this._token !== null)
      address.searchParams.set("token", this._token);
    return new WebSocket(address, protocol);
  }

  /** Saves a file of the server in the browser's downloads. */
  async download(path: string, name: string): Promise<void> {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await (await this.send(path)).blob());
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }
}

export class ApiError extends Error {
  /** The HTTP status, 0 if there was no answer. */
  readonly status: number;

  constructor(status: number, message: string) {
    super(message);
    this.status = status;
  }
}

// A browser may refuse to keep anything.
function readToken(): string | null {
  try {
    return sessionStorage.getItem(TokenName);
  } catch {
    return null;
  }
}

function keepToken(token: string): boolean {
  try {
    sessionStorage.setItem(TokenName, token);
    return true;
  } catch {
    return false;
  }
}

function sentenceOf(answer: string, status: number): string {
  try {
    return (JSON.parse(answer) as { error: string }).error;
  } catch {
    return `The program answered with status ${status}.`;
  }
}
