// The server's API: objects in, objects out; whatever goes wrong is an ApiError.

export class ApiError extends Error {
  constructor(error, status) {
    super(error.message);
    this.error = error;
    this.status = status;
  }
}

// The answer is not wanted any more.
export class GivenUp extends Error {}

// Of the recording that the page shows: the server refuses what is asked about another.
let opening = null;
export const shownOpening = () => opening;
export const showsOpening = number => { opening = number; };

// What opens a recording is about none, but for the model that is kept.
const opens = path => /^\/api\/(recording|example|session)\b/.test(path);
const about = (path, posts) => opening !== null && !/^\/api\/(state|effects|columns|table)\b/.test(path) &&
  !(posts && opens(path) && !/[?&]keep=1/.test(path));
const addressed = (path, posts) => about(path, posts)
  ? `${path}${path.includes('?') ? '&' : '?'}opening=${opening}` : path;

const none = signal => signal?.aborted ? new GivenUp()
  : new ApiError({message: 'The program behind this page does not answer.'}, 0);

async function answered(path, options = {}) {
  const posts = options.method === 'POST';
  let response;
  try {
    response = await fetch(addressed(path, posts), options);
  } catch {
    throw none(options.signal);
  }
  if (response.ok) return response;
  const json = await response.json().catch(() => null);
  if (options.signal?.aborted) throw new GivenUp();
  throw new ApiError(json?.error ?? {message: `The server answered ${response.status}.`}, response.status);
}

async function ask(path, options) {
  const response = await answered(path, options);
  const text = await whole(response, 'text', options?.signal);
  let json = null;
  try {
    json = text ? JSON.parse(text) : null;
  } catch { // cut off
    throw none();
  }
  if (options?.method === 'POST' && opens(path)) opening = json.opening;
  return json;
}

export const get = path => ask(path);
// The rest of an answer that has begun.
async function whole(response, kind, signal) {
  try {
    return await response[kind]();
  } catch { // it ended in the middle of it
    throw none(signal);
  }
}

export const getText = async path => whole(await answered(path), 'text');

export const post = (path, body = undefined, signal = undefined) =>
  ask(path, {method: 'POST', signal, body: body instanceof Blob || typeof body === 'string'
    ? body : body && JSON.stringify(body)});

export const postForText = async (path, body, signal) =>
  whole(await answered(path, {method: 'POST', body, signal}), 'text', signal);

export const withQuery = (path, values) => {
  const query = new URLSearchParams(Object.entries(values).filter(([, v]) => v));
  return query.size ? `${path}?${query}` : path;
};

export function save(name, blob) {
  const link = Object.assign(document.createElement('a'), {href: URL.createObjectURL(blob), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// Saves the file that the server gives under the name that it gives.
export async function download(path) {
  const response = await answered(path);
  const [, name] = /filename="(.*)"/.exec(response.headers.get('Content-Disposition')) ?? [];
  save(name ?? '', await whole(response, 'blob'));
}
