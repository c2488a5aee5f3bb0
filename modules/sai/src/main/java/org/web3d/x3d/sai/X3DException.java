package org.web3d.x3d.sai;

/** The root of all exceptions of the SAI. All are unchecked, as in the browsers that exist. */
public class X3DException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public X3DException() {}

  /** An exception that says what is wrong in one sentence. */
  public X3DException(String message) {
    super(message);
  }
}
