/** What could not be done; the message says what failed and the remedy. */
export class BrindleError extends Error {
  constructor(message) {
    super(message);
    this.name = 'BrindleError';
  }
}
