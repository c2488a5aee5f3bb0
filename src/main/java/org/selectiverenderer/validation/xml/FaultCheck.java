package org.selectiverenderer.validation.xml;

import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.x3d.source.DocumentFault;

/** Reports the faults that the parser found. */
final class FaultCheck implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    for (DocumentFault fault : file.document().faults()) {
      findings.add(rule(fault.kind()), fault.location(), "", fault.message());
    }
  }

  private static Rule rule(DocumentFault.Kind kind) {
    return switch (kind) {
      case REFUSED -> XmlRules.NO_X3D;
      case COMPRESSION -> XmlRules.COMPRESSION;
      case ENCODING -> XmlRules.ENCODING;
      case ENTITY -> XmlRules.ENTITY;
      case SYNTAX -> XmlRules.NOT_WELL_FORMED;
      case LIMIT -> XmlRules.LIMIT;
    };
  }
}
