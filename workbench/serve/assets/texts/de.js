// German. Keys are the English sentences of the page and of the server.
export default {
};
