package org.selectiverenderer.browser.sai;

import org.web3d.x3d.sai.InvalidProtoException;
import org.web3d.x3d.sai.X3DExternProtoDeclaration;
import org.web3d.x3d.sai.X3DProtoDeclaration;
import org.web3d.x3d.sai.X3DProtoInstance;
import org.web3d.x3d.sai.X3DScene;

/**
 * The prototype methods of the SAI's scene interface for a browser that expands prototype instances
 * when a file is read: all lists are empty and no name is found.
 */
abstract class PrototypelessSceneAdapter implements X3DScene {
  /** Throws if the scene was disposed of. */
  abstract void check();

  @Override
  public String[] getProtosNames() {
    check();
    return new String[0];
  }

  @Override
  public X3DProtoDeclaration getProtoDeclaration(String name) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void updateProtoDeclaration(String name, X3DProtoDeclaration declaration) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void removeProtoDeclaration(String name) {
    check();
  }

  @Override
  public String[] getExternProtoNames() {
    check();
    return new String[0];
  }

  @Override
  public X3DExternProtoDeclaration getExternProtoDeclaration(String name) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void updateExternProtoDeclaration(String name, X3DExternProtoDeclaration declaration) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void removeExternProtoDeclaration(String name) {
    check();
  }

  private static InvalidProtoException noPrototype(String name) {
    return new InvalidProtoException(
        "there is no prototype %s: instances are expanded while a file is read".formatted(name));
  }

  @Override
  public X3DProtoInstance createProto(String name) {
    check();
    throw noPrototype(name);
  }
}
