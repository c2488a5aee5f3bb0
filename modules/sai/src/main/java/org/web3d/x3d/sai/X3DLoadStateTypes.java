package org.web3d.x3d.sai;

/** How far an external prototype is loaded. */
public interface X3DLoadStateTypes {
  /** Nothing was asked for yet. */
  int LOAD_NOT_STARTED = 1;

  /** It is being loaded. */
  int LOAD_IN_PROGRESS = 2;

  /** It is there. */
  int LOAD_COMPLETED = 3;

  /** It cannot be had. */
  int LOAD_FAILED = 4;
}
