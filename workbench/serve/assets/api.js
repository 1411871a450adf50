// The server's API: objects in, objects out; whatever goes wrong is an ApiError.

export class ApiError extends Error {
  constructor(error, status) {
    super(error.message);
    this.error = error;
    this.status = status;
  }
}

async function ask(path, options) {
  let response;
  try {
    response = await fetch(path, options);
  } catch {
    throw new ApiError({message: 'The program behind this page does not answer.'}, 0);
  }
  const json = await response.json().catch(() => null);
  if (!response.ok) {
    throw new ApiError(json?.error ?? {message: `The server answered ${response.status}.`},
                       response.status);
  }
  return json;
}

export const get = path => ask(path);

export const post = (path, body = undefined) =>
  ask(path, {method: 'POST', body: body instanceof Blob || typeof body === 'string'
    ? body : body && JSON.stringify(body)});

export const withQuery = (path, values) => {
  const query = new URLSearchParams(Object.entries(values).filter(([, v]) => v));
  return query.size ? `${path}?${query}` : path;
};
