package org.selectiverenderer.x3d.read;

/** A prototype that a ProtoInstance may refer to: declared in this file or in another. */
sealed interface DeclaredPrototype permits ProtoDeclaration, ExternProtoDeclaration {
  String name();
}
