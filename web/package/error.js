/** A failure; the message has the reason and the remedy. */
export class BrindleError extends Error {
  constructor(message) {
    super(message);
    this.name = 'BrindleError';
  }
}
