// SPDX-License-Identifier: Apache-2.0
// Distance and contacts of two shapes, and one step of a universe.
using System;
using Abut;

internal static class FirstQuery
{
    private static void Main()
    {
        using (Shape ball = Shape.Sphere(1), box = Shape.Box(1, 1, 1))
        using (var universe = new Universe())
        {
            Pose origin = new Pose(0, 0, 0), above = new Pose(0, 0, 1.75);

            Distance found = Pair.Distance(box, origin, ball, above);
            Console.WriteLine($"distance {found.Value}, normal {found.Normal}");
            Console.WriteLine($"two boxes touch in {Pair.Contacts(box, origin, box, above).Length} points");

            universe.AddGeometry(universe.AddPart(origin), box);
            universe.AddGeometry(universe.AddPart(above), ball);
            universe.Step(0.01);
            foreach (Contact contact in universe.Contacts())
            {
                Console.WriteLine($"contact {-contact.Distance} deep");
            }
        }
    }
}
