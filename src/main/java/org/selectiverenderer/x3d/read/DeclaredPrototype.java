package org.selectiverenderer.x3d.read;

/** What a ProtoInstance may name. */
sealed interface DeclaredPrototype permits ProtoDeclaration, ExternDeclaration {
  String name();
}
