package org.web3d.x3d.sai;

/** The declaration of a prototype that another file defines (X3D 4.0, 4.4.5). */
public interface X3DExternProtoDeclaration extends X3DProtoDeclaration {
  /** How far it is loaded, a number of {@link X3DLoadStateTypes}. */
  int getLoadState();

  /** Asks for it to be loaded now. */
  void loadNow();

  /** The addresses of the definition, the preferred one first. */
  String[] getURLs();
}
